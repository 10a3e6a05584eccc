// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stream/Chain.h"

#include <numeric>

namespace carving
{

template <int D>
void Chain<D>::ByStep::Fill(const std::vector<int>& stepOfItem, int lastStep)
{
  std::vector<int> begins(lastStep + 2, 0);
  for (const int step : stepOfItem)
  {
    if (step <= lastStep)
    {
      ++begins[step + 1];
    }
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  this->Items.resize(begins.back());
  this->Ends.assign(begins.begin(), begins.end() - 1);
  for (int item = 0; item < static_cast<int>(stepOfItem.size()); ++item)
  {
    if (stepOfItem[item] <= lastStep)
    {
      this->Items[this->Ends[stepOfItem[item]]++] = item;
    }
  }
}

template <int D>
std::vector<int> Chain<D>::ByStep::Get(int step) const
{
  const int begin = step == 0 ? 0 : this->Ends[step - 1];
  return { this->Items.begin() + begin, this->Items.begin() + this->Ends[step] };
}

template <int D>
Chain<D>::Chain(const StoredStream<D>& stream)
  : LastStep(stream.Order.LastStep())
{
  std::vector<int> births, deaths;
  const std::size_t numberOfPoints = stream.Mesh.Surface.Points.size();
  std::vector<int> vertexBirths(numberOfPoints, Stream::Never);
  std::vector<int> vertexDeaths(numberOfPoints, 0);
  ForEachFace(stream,
    [&](const FaceLife<D>& face)
    {
      this->Faces.push_back(face);
      births.push_back(face.Birth);
      deaths.push_back(face.Death);
      for (const int vertex : face.Corners)
      {
        vertexBirths[vertex] = std::min(vertexBirths[vertex], face.Birth);
        vertexDeaths[vertex] = std::max(vertexDeaths[vertex], face.Death);
      }
    });
  for (std::size_t vertex = 0; vertex < numberOfPoints; ++vertex)
  {
    if (vertexBirths[vertex] == Stream::Never)
    {
      vertexDeaths[vertex] = Stream::Never; // it never shows
    }
  }
  this->FaceBirths.Fill(births, this->LastStep);
  this->FaceDeaths.Fill(deaths, this->LastStep);
  this->VertexBirths.Fill(vertexBirths, this->LastStep);
  this->VertexDeaths.Fill(vertexDeaths, this->LastStep);
}

template <int D>
std::vector<FaceLife<D>> Chain<D>::Select(const std::vector<int>& indices) const
{
  std::vector<FaceLife<D>> selected;
  for (const int index : indices)
  {
    selected.push_back(this->Faces[index]);
  }
  return selected;
}

template <int D>
ChainUpdate<D> Chain<D>::Next()
{
  ++this->Step;
  return { this->Select(this->FaceDeaths.Get(this->Step)),
    this->Select(this->FaceBirths.Get(this->Step)), this->VertexBirths.Get(this->Step),
    this->VertexDeaths.Get(this->Step) };
}

template <int D>
ChainUpdate<D> Chain<D>::Previous()
{
  --this->Step;
  return { this->Select(this->FaceBirths.Get(this->Step + 1)),
    this->Select(this->FaceDeaths.Get(this->Step + 1)), this->VertexDeaths.Get(this->Step + 1),
    this->VertexBirths.Get(this->Step + 1) };
}

template class Chain<2>;
template class Chain<3>;

} // namespace carving
