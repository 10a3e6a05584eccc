// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Streams with damaged arrays: each is refused with a single error that names the array and the
 * damage.
 */
#include "StreamTesting.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExtractCarvedLOD.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

enum Place
{
  Points,
  Cells,
  Field
};

vtkFieldData* GetData(vtkUnstructuredGrid* stream, Place place)
{
  return place == Points ? static_cast<vtkFieldData*>(stream->GetPointData())
    : place == Cells     ? static_cast<vtkFieldData*>(stream->GetCellData())
                         : stream->GetFieldData();
}

struct Name
{
  Place In;
  const char* Text;
};

/** All arrays on which the levels, or their selection, depend. */
const Name AllNames[] = { { Points, "vtkOriginalPointIds" }, { Points, "SnapDistance" },
  { Cells, "Priority" }, { Cells, "Depth" }, { Cells, "Step" }, { Cells, "Region" },
  { Cells, "SolidSides" }, { Cells, "vtkOriginalCellIds" }, { Field, "PriorityMeasure" },
  { Field, "KeepBothFoldSides" }, { Field, "Strategy" }, { Field, "KeptDistance" },
  { Field, "KeptDistance99" }, { Field, "KeptDistanceMean" }, { Field, "MetShare" },
  { Field, "SnapDistance" }, { Field, "ProfileVertices" }, { Field, "ProfileTriangles" },
  { Field, "ProfileComponents" }, { Field, "ProfileTunnels" }, { Field, "ProfileVoids" },
  { Field, "ProfileVolume" }, { Field, "ProfilePriority" }, { Field, "ProfileError" } };

/** A copy of the stream without an array, and a copy of that array. */
struct Taken
{
  vtkSmartPointer<vtkUnstructuredGrid> Stream;
  vtkSmartPointer<vtkAbstractArray> Array;

  Taken(vtkUnstructuredGrid* stream, const Name& name)
    : Stream(vtkSmartPointer<vtkUnstructuredGrid>::New())
  {
    this->Stream->DeepCopy(stream);
    vtkAbstractArray* array = GetData(this->Stream, name.In)->GetAbstractArray(name.Text);
    EXPECT_TRUE(array) << name.Text;
    this->Array.TakeReference(array->NewInstance());
    this->Array->DeepCopy(array);
    GetData(this->Stream, name.In)->RemoveArray(name.Text);
  }

  void Add(const Name& name, vtkAbstractArray* array)
  {
    array->SetName(name.Text);
    GetData(this->Stream, name.In)->AddArray(array);
  }
};

std::string Quoted(const Name& name)
{
  return "the array \"" + std::string(name.Text) + "\" ";
}

/** The error after a value of an array has been replaced. */
void ExpectValueRefused(vtkUnstructuredGrid* whole, const Name& name, vtkIdType at, double value)
{
  Taken taken(whole, name);
  vtkNew<vtkDoubleArray> changed; // other types cannot hold some of the values
  changed->DeepCopy(taken.Array);
  changed->SetValue(at, value);
  taken.Add(name, changed);
  ExpectError(taken.Stream, Quoted(name) + "has the value ");
}

} // namespace

// The undamaged streams of these tests are accepted.
TEST(DamagedStreams, AreRefusedForTheDamageOnly)
{
  EXPECT_EQ(ErrorOf(MakeStream()), "");
  EXPECT_EQ(ErrorOf(MakeStream(true)), "");
}

// An array that is too short or too long is named, in space and in the plane.
TEST(DamagedStreams, AreRefusedForArraysOfAnotherLength)
{
  for (const bool plane : { false, true })
  {
    const auto whole = MakeStream(plane);
    for (const Name& name : AllNames)
    {
      for (const int more : { -1, 1 })
      {
        Taken taken(whole, name);
        const vtkIdType length = taken.Array->GetNumberOfTuples();
        taken.Array->Resize(length + 1);
        taken.Array->SetNumberOfTuples(length + more);
        if (auto* numbers = vtkDataArray::SafeDownCast(taken.Array); numbers && more > 0)
        {
          numbers->SetTuple1(length, numbers->GetTuple1(length - 1));
        }
        taken.Add(name, taken.Array);
        // The lengths of all arrays of the profile are compared with that of the priorities.
        const bool measure = std::string(name.Text) == "ProfilePriority";
        ExpectError(taken.Stream, measure ? "the array \"Profile" : Quoted(name) + "has ");
      }
    }
  }
}

// An array of the input that a filter has shortened is named, since levels would pass it on.
TEST(DamagedStreams, AreRefusedForDataOfAnotherLength)
{
  for (const Place place : { Points, Cells })
  {
    const auto stream = MakeStream();
    vtkNew<vtkStringArray> labels;
    labels->SetName("Labels");
    labels->InsertNextValue("one");
    GetData(stream, place)->AddArray(labels);
    ExpectError(stream, "the array \"Labels\" has 1 tuples instead of ");
  }
}

// A missing array is named, unless it is optional.
TEST(DamagedStreams, AreRefusedForArraysThatAreMissing)
{
  const auto whole = MakeStream();
  for (const Name& name : AllNames)
  {
    const std::string text = name.Text;
    const Taken taken(whole, name);
    if (text == "KeptDistance" || text == "KeptDistance99" || text == "KeptDistanceMean" ||
      text == "MetShare" || text == "SnapDistance" || text == "ProfileError" || text == "Strategy")
    {
      EXPECT_EQ(ErrorOf(taken.Stream), "") << text;
    }
    else
    {
      ExpectError(taken.Stream, Quoted(name) + "is missing");
    }
  }
}

// Text instead of numbers, and numbers instead of text, are named.
TEST(DamagedStreams, AreRefusedForArraysOfAnotherType)
{
  const auto whole = MakeStream();
  for (const Name& name : AllNames)
  {
    Taken taken(whole, name);
    vtkNew<vtkStringArray> text;
    vtkNew<vtkIntArray> number;
    text->SetNumberOfValues(taken.Array->GetNumberOfTuples());
    number->SetNumberOfValues(1);
    const bool isText = vtkStringArray::SafeDownCast(taken.Array) != nullptr;
    taken.Add(name, isText ? static_cast<vtkAbstractArray*>(number) : text);
    ExpectError(taken.Stream, Quoted(name) + (isText ? "has no text" : "has no numbers"));
  }
}

// An array of several components is named.
TEST(DamagedStreams, AreRefusedForArraysOfSeveralComponents)
{
  const auto whole = MakeStream();
  for (const Name& name : AllNames)
  {
    Taken taken(whole, name);
    if (vtkStringArray::SafeDownCast(taken.Array))
    {
      continue;
    }
    vtkNew<vtkDoubleArray> pairs;
    pairs->SetNumberOfComponents(2);
    pairs->SetNumberOfTuples(taken.Array->GetNumberOfTuples());
    pairs->Fill(0.0);
    taken.Add(name, pairs);
    ExpectError(taken.Stream, Quoted(name) + "has 2 components instead of 1");
  }
}

// A value that is not an integer is refused in every array of integers.
TEST(DamagedStreams, AreRefusedForValuesThatAreNoIntegers)
{
  const auto whole = MakeStream();
  const vtkIdType facet = whole->GetNumberOfCells() - 1;
  const std::pair<Name, vtkIdType> places[] = { { { Points, "vtkOriginalPointIds" }, 0 },
    { { Cells, "Step" }, 0 }, { { Cells, "Region" }, 0 }, { { Cells, "SolidSides" }, facet },
    { { Cells, "vtkOriginalCellIds" }, facet }, { { Field, "PriorityMeasure" }, 0 },
    { { Field, "KeepBothFoldSides" }, 0 }, { { Field, "ProfileVertices" }, 1 },
    { { Field, "ProfileTriangles" }, 1 }, { { Field, "ProfileComponents" }, 1 },
    { { Field, "ProfileTunnels" }, 1 }, { { Field, "ProfileVoids" }, 1 } };
  for (const auto& [name, at] : places)
  {
    for (const double value : { NaN, Infinity, -Infinity, 0.5, 1e300, -1e300, 4294967296.0 })
    {
      ExpectValueRefused(whole, name, at, value);
    }
  }
}

// Integers out of range are refused: unknown steps and settings, negative counts.
TEST(DamagedStreams, AreRefusedForIntegersOutOfRange)
{
  const auto whole = MakeStream();
  const vtkIdType facet = whole->GetNumberOfCells() - 1;
  const double steps = whole->GetFieldData()->GetArray("ProfileVertices")->GetNumberOfTuples();
  const std::tuple<Name, vtkIdType, double> values[] = { { { Cells, "Step" }, 0, 0.0 },
    { { Cells, "Step" }, 0, -2.0 }, { { Cells, "Step" }, 0, steps },
    { { Cells, "Region" }, 0, -2.0 }, { { Cells, "SolidSides" }, facet, 4.0 },
    { { Cells, "SolidSides" }, facet, -1.0 }, { { Cells, "vtkOriginalCellIds" }, 0, -2.0 },
    { { Points, "vtkOriginalPointIds" }, 0, -2.0 }, { { Field, "PriorityMeasure" }, 0, 5.0 },
    { { Field, "PriorityMeasure" }, 0, -1.0 }, { { Field, "KeepBothFoldSides" }, 0, 2.0 },
    { { Field, "ProfileVertices" }, 0, -1.0 }, { { Field, "ProfileTriangles" }, 0, -1.0 },
    { { Field, "ProfileComponents" }, 0, 0.0 }, { { Field, "ProfileTunnels" }, 0, -1.0 },
    { { Field, "ProfileVoids" }, 0, -1.0 } };
  for (const auto& [name, at, value] : values)
  {
    ExpectValueRefused(whole, name, at, value);
  }
}

// Impossible measures are refused: NaN, negative or infinite values, a volume that grows.
TEST(DamagedStreams, AreRefusedForMeasuresThatCannotBe)
{
  const auto whole = MakeStream();
  const Name measures[] = { { Cells, "Priority" }, { Cells, "Depth" }, { Points, "SnapDistance" },
    { Field, "KeptDistance" }, { Field, "KeptDistance99" }, { Field, "KeptDistanceMean" },
    { Field, "MetShare" }, { Field, "SnapDistance" }, { Field, "ProfileVolume" },
    { Field, "ProfilePriority" }, { Field, "ProfileError" } };
  for (const Name& name : measures)
  {
    const vtkIdType last = GetData(whole, name.In)->GetArray(name.Text)->GetNumberOfTuples() - 1;
    const vtkIdType at = name.In == Cells ? 0 : last;
    ExpectValueRefused(whole, name, at, NaN);
    ExpectValueRefused(whole, name, at, -1.0);
  }
  ExpectValueRefused(whole, { Cells, "Depth" }, 0, Infinity);
  ExpectValueRefused(whole, { Field, "ProfileError" }, 0, Infinity);
  ExpectValueRefused(whole, { Field, "ProfilePriority" }, 0, 1.0);
  ExpectValueRefused(whole, { Field, "ProfileVolume" }, 0, Infinity);
  ExpectValueRefused(whole, { Field, "ProfileVolume" }, 1, 1e30);
}

// Counts that contradict the cells are refused.
TEST(DamagedStreams, AreRefusedForAProfileOfOtherCells)
{
  for (const bool plane : { false, true })
  {
    const auto whole = MakeStream(plane);
    for (const char* text : { "ProfileVertices", "ProfileTriangles" })
    {
      const Name name = { Field, text };
      Taken taken(whole, name);
      auto* counts = vtkIntArray::SafeDownCast(taken.Array);
      counts->SetValue(1, counts->GetValue(1) + 1);
      taken.Add(name, counts);
      ExpectError(taken.Stream, Quoted(name) + "contradicts the cells");
    }
  }
}

// Levels do not depend on the ranges of targets. Damaged ranges are unknown.
TEST(DamagedStreams, GiveLevelsWithoutRanges)
{
  const Name name = { Field, "TargetRanges" };
  const auto whole = MakeStream();
  for (const double value : { NaN, -1.0 })
  {
    Taken taken(whole, name);
    vtkDataArray::SafeDownCast(taken.Array)->SetComponent(2, 1, value);
    taken.Add(name, taken.Array);
    EXPECT_EQ(ErrorOf(taken.Stream), "");
    vtkNew<vtkExtractCarvedLOD> extract;
    extract->SetInputData(taken.Stream);
    double range[2];
    EXPECT_FALSE(extract->GetLevelTargetRange(vtkExtractCarvedLOD::VERTICES, range));
  }
}
