// SPDX-License-Identifier: BSD-3-Clause
#include "HelperRun.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

HelperRun RunHelper(const std::string& input)
{
  // Unique names, since tests may run in parallel.
  const std::string stem = testing::TempDir() + "carving-helper-test-" + std::to_string(getpid());
  const std::string job = stem + ".job", reply = stem + ".reply";
  std::ofstream(job, std::ios::binary) << input;
  const std::string command =
    "\"" CARVING_HELPER "\" < \"" + job + "\" > \"" + reply + "\" 2> /dev/null";
  const int status = std::system(command.c_str());

  HelperRun run;
  run.ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  std::ifstream in(reply, std::ios::binary);
  run.Output.assign(std::istreambuf_iterator<char>(in), {});
  run.Mistake = carving::Read(run.Output.data(), run.Output.size(), run.Reply);
  std::remove(job.c_str());
  std::remove(reply.c_str());
  return run;
}

HelperRun RunHelper(const carving::Job& job)
{
  return RunHelper(ToBytes(job));
}

HelperRun RunHelper(const carving::TriangleMesh& mesh, carving::JobKind kind)
{
  carving::Job job;
  job.Kind = kind;
  job.Mesh = mesh;
  return RunHelper(job);
}

carving::Reply GetReply(const carving::Job& job)
{
  HelperRun run = RunHelper(job);
  if (!run.Succeeded())
  {
    throw std::runtime_error("carving-helper: " + run.Mistake + run.Reply.Error);
  }
  return std::move(run.Reply);
}

carving::Reply GetReply(const carving::TriangleMesh& mesh)
{
  carving::Job job;
  job.Mesh = mesh;
  return GetReply(job);
}

carving::Reply GetReply(const carving::TriangleMesh& mesh, carving::Conformity conformity,
  double tolerance, carving::InitialApproximation initial)
{
  carving::Job job;
  job.EnclosingTolerance = tolerance;
  job.Mesh = mesh;
  job.Initial = initial;
  job.Conformity = conformity;
  return GetReply(job);
}
