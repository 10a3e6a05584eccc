// SPDX-License-Identifier: BSD-3-Clause
// The size of the helper program's memory pages, on Linux.
#include "Helper/MemoryPages.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

using namespace carving::helper;

namespace
{

/** A folder of devices as Linux lists them, gone at the end. */
class Devices
{
public:
  Devices()
    : Folder(std::filesystem::path(testing::TempDir()) / ("balloons-" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->Folder);
    std::ofstream(this->Folder / "bind");
  }
  ~Devices()
  {
    std::filesystem::remove_all(this->Folder);
  }

  void Add(const std::string& name, const std::string& features) const
  {
    std::filesystem::create_directories(this->Folder / name);
    std::ofstream(this->Folder / name / "features") << features << '\n';
  }

  const std::filesystem::path Folder;
};

} // namespace

// A machine without a memory balloon keeps its free pages.
TEST(MemoryPages, StayOnMachinesWithoutBalloon)
{
  const Devices devices;
  EXPECT_FALSE(ReturnsFreePages(devices.Folder));
  EXPECT_FALSE(ReturnsFreePages(devices.Folder / "missing"));
}

// A virtual machine returns free pages if it and its host agreed on the standard's feature 5.
TEST(MemoryPages, AreReturnedIfAgreed)
{
  const Devices devices;
  devices.Add("virtio0", "11111011111111111111111111111111");
  devices.Add("virtio1", "");
  EXPECT_FALSE(ReturnsFreePages(devices.Folder));
  devices.Add("virtio2", "00000100000000000000000000000000");
  EXPECT_TRUE(ReturnsFreePages(devices.Folder));
}
