// SPDX-License-Identifier: BSD-3-Clause
#include "GltfWriter.h"

#include "LevelNumbers.h"
#include "Objects.h"

#include "vtkByteSwap.h"
#include "vtkCellArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>

namespace
{

// Numbers of the format.
constexpr int Float = 5126;
constexpr int UnsignedInt = 5125;
constexpr int ArrayBuffer = 34962;
constexpr int ElementArrayBuffer = 34963;
constexpr int Version = 2;

/** Appends numbers in the byte order of the format. All numbers have four bytes. */
template <class Number>
void Append(std::string& bytes, std::vector<Number> numbers)
{
  static_assert(sizeof(Number) == 4, "the alignment of the format");
  vtkByteSwap::SwapLERange(numbers.data(), numbers.size());
  bytes.append(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
}

/** A chunk with its header, filled up to a multiple of four bytes. */
std::string MakeChunk(const char* type, std::string content, char filling)
{
  content.resize((content.size() + 3) / 4 * 4, filling);
  std::string chunk;
  Append<std::uint32_t>(chunk, { static_cast<std::uint32_t>(content.size()) });
  return chunk + std::string(type, 4) + content;
}

/** A JSON document and the buffer to which it refers. */
class Document
{
public:
  Document()
  {
    this->Root["asset"]["version"] = "2.0";
    this->Root["asset"]["generator"] = "carve " CARVE_VERSION;
    // Sheets are visible from both sides.
    this->Root["materials"][0]["doubleSided"] = true;
    this->Root["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0.0;
    this->Root["scene"] = 0;
    this->Root["scenes"][0]["nodes"] = Json::Value(Json::arrayValue);
  }

  void AddScene(vtkMultiBlockDataSet* tree)
  {
    for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
    {
      this->Root["scenes"][0]["nodes"].append(
        this->AddNode(GetBlockName(tree, i), tree->GetBlock(i)));
    }
  }

  /** The bytes of the file; empty if they are more than the format allows. */
  std::string ToBytes()
  {
    this->Root["buffers"][0]["byteLength"] = Json::UInt64(this->Buffer.size());
    const std::string json = MakeChunk("JSON", ToText(this->Root, ""), ' ');
    const std::string binary = MakeChunk(std::string("BIN\0", 4).data(), this->Buffer, '\0');
    constexpr std::size_t header = 12;
    const std::size_t size = header + json.size() + binary.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
    {
      return {};
    }
    std::string bytes = "glTF";
    Append<std::uint32_t>(bytes, { Version, static_cast<std::uint32_t>(size) });
    return bytes + json + binary;
  }

private:
  Json::Value Root;
  std::string Buffer;

  int Add(const char* list, const Json::Value& value)
  {
    this->Root[list].append(value);
    return static_cast<int>(this->Root[list].size()) - 1;
  }

  int AddNode(const std::string& name, vtkDataObject* block)
  {
    Json::Value node(Json::objectValue);
    node["name"] = name;
    auto* tree = vtkMultiBlockDataSet::SafeDownCast(block);
    for (unsigned int i = 0; tree && i < tree->GetNumberOfBlocks(); ++i)
    {
      node["children"].append(this->AddNode(GetBlockName(tree, i), tree->GetBlock(i)));
    }
    if (auto* level = vtkPolyData::SafeDownCast(block))
    {
      node["mesh"] = this->AddMesh(level);
      node["extras"] = GetLevelNumbers(level);
    }
    return this->Add("nodes", node);
  }

  int AddMesh(vtkPolyData* level)
  {
    vtkNew<vtkPolyData> surface; // without the arrays of the level
    surface->SetPoints(level->GetPoints());
    surface->SetPolys(level->GetPolys());
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(surface);
    normals->ConsistencyOff();
    normals->Update();
    vtkPolyData* smooth = normals->GetOutput();
    Json::Value primitive(Json::objectValue);
    primitive["attributes"]["POSITION"] = this->AddVectors(smooth->GetPoints()->GetData(), true);
    primitive["attributes"]["NORMAL"] =
      this->AddVectors(smooth->GetPointData()->GetNormals(), false);
    primitive["indices"] = this->AddTriangles(smooth->GetPolys());
    primitive["material"] = 0;
    Json::Value mesh(Json::objectValue);
    mesh["primitives"].append(primitive);
    return this->Add("meshes", mesh);
  }

  int AddVectors(vtkDataArray* vectors, bool withRange)
  {
    std::vector<float> numbers;
    Json::Value least(Json::arrayValue), greatest(Json::arrayValue);
    for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        numbers.push_back(static_cast<float>(vectors->GetComponent(i, c)));
      }
    }
    for (std::size_t c = 0; withRange && c < 3; ++c)
    {
      float range[2] = { numbers[c], numbers[c] };
      for (std::size_t i = c; i < numbers.size(); i += 3)
      {
        range[0] = std::min(range[0], numbers[i]);
        range[1] = std::max(range[1], numbers[i]);
      }
      least.append(range[0]);
      greatest.append(range[1]);
    }
    Json::Value accessor(Json::objectValue);
    if (withRange)
    {
      accessor["min"] = least;
      accessor["max"] = greatest;
    }
    accessor["count"] = Json::Int64(vectors->GetNumberOfTuples());
    accessor["type"] = "VEC3";
    accessor["componentType"] = Float;
    return this->AddNumbers(accessor, ArrayBuffer, numbers);
  }

  int AddTriangles(vtkCellArray* triangles)
  {
    std::vector<std::uint32_t> corners;
    for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      triangles->GetCellAtId(i, size, ids);
      corners.insert(corners.end(), ids, ids + size);
    }
    Json::Value accessor(Json::objectValue);
    accessor["count"] = Json::UInt64(corners.size());
    accessor["type"] = "SCALAR";
    accessor["componentType"] = UnsignedInt;
    return this->AddNumbers(accessor, ElementArrayBuffer, corners);
  }

  template <class Number>
  int AddNumbers(Json::Value& accessor, int target, const std::vector<Number>& numbers)
  {
    Json::Value view(Json::objectValue);
    view["buffer"] = 0;
    view["byteOffset"] = Json::UInt64(this->Buffer.size());
    view["byteLength"] = Json::UInt64(4 * numbers.size());
    view["target"] = target;
    Append(this->Buffer, numbers);
    accessor["bufferView"] = this->Add("bufferViews", view);
    return this->Add("accessors", accessor);
  }
};

} // namespace

std::string GltfWriter::Write(const std::string& fileName, vtkMultiBlockDataSet* tree)
{
  Document document;
  document.AddScene(tree);
  const std::string bytes = document.ToBytes();
  if (bytes.empty())
  {
    return "a .glb file cannot be larger than 4 GB; .vtm and .vtpc can";
  }
  std::ofstream file(fileName, std::ios::binary);
  file << bytes;
  file.close();
  return !file.fail() ? "" : "the disk is full, or the place cannot be written";
}
