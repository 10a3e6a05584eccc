// SPDX-License-Identifier: BSD-3-Clause
#include "LevelNumbers.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <cmath>

Json::Value GetLevelNumbers(vtkPolyData* level)
{
  Json::Value numbers(Json::objectValue);
  for (const auto& [key, name] : { std::pair("step", "Step"), std::pair("vertices", "Vertices"),
         std::pair("triangles", "Triangles"), std::pair("components", "Components"),
         std::pair("tunnels", "Tunnels"), std::pair("voids", "Voids"),
         std::pair("feature_size", "FeatureSize"), std::pair("error", "Error") })
  {
    vtkDataArray* array = level->GetFieldData()->GetArray(name);
    const double number = array ? array->GetTuple1(0) : -1.0; // a negative one is unknown, too
    const bool whole = array && array->GetDataType() != VTK_DOUBLE;
    numbers[key] = !std::isfinite(number) || number < 0.0 ? Json::Value()
      : whole                                             ? Json::Value(Json::Int64(number))
                                                          : Json::Value(number);
  }
  return numbers;
}

std::string ToText(const Json::Value& value, const std::string& indentation)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = indentation;
  return Json::writeString(builder, value);
}
