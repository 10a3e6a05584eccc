// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the helper program as a separate process, through files, so that a crash cannot end the
 * tests.
 */
#ifndef HelperRun_h
#define HelperRun_h

#include "Core/Protocol/Protocol.h"

#include <sstream>
#include <string>

struct HelperRun
{
  int ExitCode = -1;
  std::string Output;  ///< its standard output
  std::string Mistake; ///< why the output cannot be read as a reply
  carving::Reply Reply;

  bool Succeeded() const
  {
    return this->ExitCode == 0 && this->Mistake.empty() && this->Reply.Error.empty();
  }
};

HelperRun RunHelper(const std::string& input);
HelperRun RunHelper(const carving::Job& job);
HelperRun RunHelper(
  const carving::TriangleMesh& mesh, carving::JobKind kind = carving::JobKind::Tetrahedralize);

/** Runs the helper program, and throws an exception unless it succeeds. */
carving::Reply GetReply(const carving::Job& job);
carving::Reply GetReply(const carving::TriangleMesh& mesh);
/** Without a tolerance, an enclosed mesh is not refined. */
carving::Reply GetReply(const carving::TriangleMesh& mesh, carving::Conformity conformity,
  double tolerance = 0.0,
  carving::InitialApproximation initial = carving::InitialApproximation::ConvexHull);

/** A job or a reply as bytes. */
template <class Message>
std::string ToBytes(const Message& message)
{
  std::ostringstream bytes;
  carving::Write(bytes, message);
  return bytes.str();
}

#endif
