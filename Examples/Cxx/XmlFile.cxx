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
    vtkXMLWriter* writer = this->GetWriter(index);
    writer->WriteToOutputStringOn();
    const int written = this->Superclass::WriteNonCompositeData(block, element, index, fileName);
    this->AllSaved = Save(std::string(this->GetFilePath()) + fileName, writer) && this->AllSaved;
    return written;
  }
};
vtkStandardNewMacro(MultiBlockWriter);

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
  return writer->Write() != 0 && Save(fileName, writer);
}

} // namespace

bool XmlFile::Write(const std::string& fileName, vtkDataObject* data)
{
  if (vtkMultiBlockDataSet::SafeDownCast(data))
  {
    vtkNew<MultiBlockWriter> writer;
    return WriteWith(writer, fileName, data) && writer->AllSaved;
  }
  vtkSmartPointer<vtkXMLWriter> writer;
  writer.TakeReference(vtkXMLDataObjectWriter::NewWriter(data->GetDataObjectType()));
  return WriteWith(writer, fileName, data);
}
