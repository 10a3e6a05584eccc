// SPDX-License-Identifier: BSD-3-Clause
#include "JsonFile.h"

#include "LevelNumbers.h"
#include "Objects.h"
#include "Options.h"
#include "Report.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

#include <fstream>
#include <iostream>

namespace
{

Json::Value ToArray(const std::vector<std::string>& texts)
{
  Json::Value array(Json::arrayValue);
  for (const std::string& text : texts)
  {
    array.append(text);
  }
  return array;
}

Json::Value Describe(const Object& object)
{
  Json::Value value(Json::objectValue);
  value["input"] = object.Input;
  value["block"] = object.Block.empty() ? Json::Value() : Json::Value(object.Block);
  value["notes"] = ToArray(GetNotes(object.Levels));
  value["levels"] = Json::Value(Json::arrayValue);
  for (unsigned int i = 0; i < object.Levels->GetNumberOfBlocks(); ++i)
  {
    Json::Value level = GetLevelNumbers(vtkPolyData::SafeDownCast(object.Levels->GetBlock(i)));
    level["level"] = i;
    value["levels"].append(level);
  }
  return value;
}

Json::Value Describe(const Options& options, const Report& report)
{
  const std::vector<Object> objects = ListObjects(options.Inputs, report.Levels);
  Json::Value value(Json::objectValue);
  value["version"] = CARVE_VERSION;
  value["objects"] = Json::Value(Json::arrayValue);
  for (const Object& object : objects)
  {
    value["objects"].append(Describe(object));
  }
  value["notes"] =
    ToArray(objects.size() > 1 ? GetNotes(report.Levels) : std::vector<std::string>());
  value["warnings"] = ToArray(report.Warnings);
  value["errors"] = ToArray(report.Errors);
  value["files"] = ToArray(report.Files);
  value["seconds"] = Json::Value(Json::objectValue);
  for (const auto& [stage, seconds] : report.Clock.GetSeconds())
  {
    value["seconds"][stage] = seconds;
  }
  return value;
}

} // namespace

bool JsonFile::Write(const Options& options, const Report& report)
{
  const std::string text = ToText(Describe(options, report), "  ") + "\n";
  if (options.Json == "-")
  {
    return static_cast<bool>(std::cout << text << std::flush);
  }
  std::ofstream file(options.Json, std::ios::binary);
  file << text;
  file.close();
  return !file.fail();
}
