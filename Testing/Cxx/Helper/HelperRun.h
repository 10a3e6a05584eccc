// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs the helper program the plain way, through files, so that nothing it does can end the tests.
 */
#ifndef HelperRun_h
#define HelperRun_h

#include "Core/Protocol/Protocol.h"

#include <string>

struct HelperRun
{
  int ExitCode = -1;
  std::string Output;  ///< what it wrote on standard output
  std::string Mistake; ///< what reading the output as a reply complained about
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

#endif
