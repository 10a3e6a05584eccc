// SPDX-License-Identifier: BSD-3-Clause
#include "ChildWork.h"
#include "System/TemporaryFile.h"

#include <gtest/gtest.h>

#include <memory>

int main(int argc, char* argv[])
{
  auto files = std::make_unique<TemporaryFile>("carving-helper-tests");
  carving::helper::BeginProgram(argc, argv, files->GetPath(),
    [&](std::istream& in)
    {
      files.reset(); // those of the parent are used
      return BelongsToStrategies() ? ResumeTestedStrategies(in) : ResumeChildWork(in);
    });
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
