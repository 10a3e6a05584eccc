// SPDX-License-Identifier: BSD-3-Clause
#include "XmlFile.h"

#include "FileName.h"

#include "vtkBase64Utilities.h"
#include "vtkConvertToPartitionedDataSetCollection.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataObjectWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtksys/SystemTools.hxx"

#include <fstream>

namespace
{

/**
 * Saves the string that a writer has made. VTK 9.1 would crash if it wrote to a file on a full
 * disk.
 */
bool Save(const std::string& fileName, vtkXMLWriter* writer)
{
  std::ofstream file(fileName, std::ios::binary);
  file << writer->GetOutputString();
  file.close();
  return !file.fail();
}

/**
 * Saves the files of all blocks in the same way, one after the other. Several writers at a time
 * would crash: a writer stores the ranges of arrays in the arrays, and levels share those of field
 * data.
 */
class MultiBlockWriter : public vtkXMLMultiBlockDataWriter
{
public:
  static MultiBlockWriter* New();
  vtkTypeMacro(MultiBlockWriter, vtkXMLMultiBlockDataWriter);

  bool AllSaved = true;

protected:
  int WriteNonCompositeData(
    vtkDataObject* block, vtkXMLDataElement* element, int& index, const char* fileName) override
  {
    if (!block)
    {
      return this->Superclass::WriteNonCompositeData(block, element, index, fileName);
    }
    vtkXMLWriter* writer = this->GetWriter(index);
    writer->WriteToOutputStringOn();
    const int written = this->Superclass::WriteNonCompositeData(block, element, index, fileName);
    this->AllSaved = Save(std::string(this->GetFilePath()) + fileName, writer) && this->AllSaved;
    return written;
  }
};
vtkStandardNewMacro(MultiBlockWriter);

/** The same tree with null in place of blocks that are empty trees, which VTK cannot write. */
vtkSmartPointer<vtkMultiBlockDataSet> WithoutEmptyBlocks(vtkMultiBlockDataSet* tree)
{
  auto result = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  result->CopyStructure(tree);
  result->SetFieldData(tree->GetFieldData());
  for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
  {
    auto* inner = vtkMultiBlockDataSet::SafeDownCast(tree->GetBlock(i));
    const bool isEmpty = inner && inner->GetNumberOfBlocks() == 0;
    result->SetBlock(i,
      isEmpty   ? nullptr
        : inner ? WithoutEmptyBlocks(inner).Get()
                : tree->GetBlock(i));
  }
  return result;
}

bool WriteWith(vtkXMLWriter* writer, const std::string& fileName, vtkDataObject* data)
{
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  // ParaView 5.11 cannot read appended data with today's libexpat1 of Debian 12.
  writer->SetDataModeToBinary();
  // With zlib, files have half the size but take three to four times as long. No compression is
  // slower, too.
  writer->SetCompressorTypeToLZ4();
  writer->SetCompressionLevel(9);
  // VTK reports some failures by an empty string only.
  return writer->Write() != 0 && !writer->GetOutputString().empty() && Save(fileName, writer);
}

/** Writes a leaf in the format of its type. */
bool WriteLeaf(const std::string& fileName, vtkDataObject* leaf)
{
  vtkSmartPointer<vtkXMLWriter> writer;
  writer.TakeReference(vtkXMLDataObjectWriter::NewWriter(leaf->GetDataObjectType()));
  return WriteWith(writer, fileName, leaf);
}

vtkXMLDataElement* AddElement(vtkXMLDataElement* parent, const char* name)
{
  vtkNew<vtkXMLDataElement> element;
  element->SetName(name);
  parent->AddNestedElement(element);
  return element;
}

/** Adds the tree of a collection, with all names. */
void AddAssembly(vtkXMLDataElement* parent, vtkDataAssembly* assembly)
{
  const std::string text = assembly->SerializeToXML(vtkIndent());
  std::string encoded((text.size() + 2) / 3 * 4, '\0');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(text.data()), text.size(),
    reinterpret_cast<unsigned char*>(&encoded[0]));
  vtkXMLDataElement* element = AddElement(parent, "DataAssembly");
  element->SetAttribute("encoding", "base64");
  element->SetCharacterData(encoded.data(), static_cast<int>(encoded.size()));
}

/**
 * Writes a tree as a partitioned data set collection: the files of the leaves in a folder, and a
 * file that refers to them. VTK's own writer of 9.1 crashes on a full disk.
 */
bool WriteCollection(const std::string& fileName, vtkMultiBlockDataSet* tree)
{
  vtkNew<vtkConvertToPartitionedDataSetCollection> convert;
  convert->SetInputDataObject(tree);
  convert->Update();
  vtkPartitionedDataSetCollection* collection = convert->GetOutput();
  const std::string folder = FileName::WithoutExtension(fileName);
  const std::string stem = vtksys::SystemTools::GetFilenameName(folder);
  vtkNew<vtkXMLDataElement> root;
  root->SetName("VTKFile");
  root->SetAttribute("type", "vtkPartitionedDataSetCollection");
  root->SetAttribute("version", "1.0");
  vtkXMLDataElement* content = AddElement(root, "vtkPartitionedDataSetCollection");
  bool good = static_cast<bool>(vtksys::SystemTools::MakeDirectory(folder));
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets() && good; ++i)
  {
    const std::string leaf = stem + "_" + std::to_string(i) + ".vtp";
    good = WriteLeaf(folder + "/" + leaf, collection->GetPartition(i, 0));
    vtkXMLDataElement* partitions = AddElement(content, "Partitions");
    partitions->SetIntAttribute("index", static_cast<int>(i));
    partitions->SetAttribute("name", collection->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()));
    vtkXMLDataElement* dataSet = AddElement(partitions, "DataSet");
    dataSet->SetIntAttribute("index", 0);
    dataSet->SetAttribute("file", (stem + "/" + leaf).c_str());
  }
  AddAssembly(content, collection->GetDataAssembly());
  std::ofstream file(fileName, std::ios::binary);
  root->PrintXML(file, vtkIndent());
  file.close();
  return good && !file.fail();
}

} // namespace

bool XmlFile::Write(const std::string& fileName, vtkDataObject* data)
{
  if (FileName::GetExtension(fileName) == ".vtpc")
  {
    return WriteCollection(fileName, vtkMultiBlockDataSet::SafeDownCast(data));
  }
  if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    vtkNew<MultiBlockWriter> writer;
    return WriteWith(writer, fileName, WithoutEmptyBlocks(tree)) && writer->AllSaved;
  }
  return WriteLeaf(fileName, data);
}
