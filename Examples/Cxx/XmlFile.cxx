// SPDX-License-Identifier: BSD-3-Clause
#include "XmlFile.h"

#include "vtkDataObject.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataObjectWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"

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

/** Saves the files of all blocks in the same way. */
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

} // namespace

bool XmlFile::Write(const std::string& fileName, vtkDataObject* data)
{
  if (auto* tree = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    vtkNew<MultiBlockWriter> writer;
    return WriteWith(writer, fileName, WithoutEmptyBlocks(tree)) && writer->AllSaved;
  }
  vtkSmartPointer<vtkXMLWriter> writer;
  writer.TakeReference(vtkXMLDataObjectWriter::NewWriter(data->GetDataObjectType()));
  return WriteWith(writer, fileName, data);
}
