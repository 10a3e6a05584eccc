// SPDX-License-Identifier: BSD-3-Clause
#include "RandomModels.h"

#include "PointMath.h"
#include "Shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace models
{
namespace
{

/** A random rotation, as the images of the axes. */
std::array<Point, 3> RandomRotation(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return Normalized({ normal(random), normal(random), normal(random) });
  };
  const Point x = direction();
  const Point z = Normalized(carving::Cross(x, direction()));
  return { x, carving::Cross(z, x), z };
}

/** Two boxes that coincide (0) or share a side (1), an edge (2) or a corner (3). */
TriangleMesh GluedBoxes(int shared)
{
  const Point shift = { shared > 0 ? 1.0 : 0.0, shared > 1 ? 1.0 : 0.0, shared > 2 ? 1.0 : 0.0 };
  const TriangleMesh box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  return Joined(box, Moved(box, shift));
}

TriangleMesh RandomPart(std::mt19937_64& random, bool& closed)
{
  const auto integer = [&](int lower, int upper)
  { return std::uniform_int_distribution<int>(lower, upper)(random); };
  std::uniform_real_distribution<double> unit;
  closed = true;
  switch (integer(0, 7))
  {
    case 0:
      return Tetrahedron();
    case 1:
      return Box({ 0, 0, 0 }, { 0.2 + unit(random), 0.2 + unit(random), 0.2 + unit(random) });
    case 2:
      return Sphere(integer(0, 2));
    case 3:
      return Torus(1.0, 0.2 + 0.5 * unit(random), integer(5, 14), integer(4, 9));
    case 4:
      return GluedBoxes(integer(0, 3));
    case 5:
      return Joined(Sphere(1), Flipped(Moved(Sphere(integer(0, 1)), {}, 0.4))); // with a void
    default:
    {
      closed = false;
      TriangleMesh sheet = Sheet(integer(1, 5));
      for (Point& p : sheet.Points)
      {
        p[2] += 0.3 * unit(random);
      }
      return sheet;
    }
  }
}

} // namespace

TriangleMesh Rotated(TriangleMesh mesh, std::mt19937_64& random)
{
  const std::array<Point, 3> axes = RandomRotation(random);
  for (Point& p : mesh.Points)
  {
    p = p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
  }
  return mesh;
}

int NumberOfCases(const char* variable, int slice)
{
#ifdef __SANITIZE_ADDRESS__
  slice = (slice + 3) / 4;
#endif
  const char* number = std::getenv(variable);
  return number ? std::atoi(number) : slice;
}

TriangleMesh Soup(int n, std::mt19937_64& random)
{
  std::uniform_int_distribution<int> coordinate(0, 10);
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.Points.push_back(
        { double(coordinate(random)), double(coordinate(random)), double(coordinate(random)) });
    }
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return mesh;
}

TriangleMesh GridSoup(int n, std::mt19937_64& random)
{
  const auto below = [&](int end)
  { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    const int axis = below(3);
    Point corner;
    for (double& x : corner)
    {
      x = below(4);
    }
    mesh.Points.insert(mesh.Points.end(), 3, corner);
    mesh.Points[3 * i + 1][(axis + 1) % 3] += 1 + below(3);
    mesh.Points[3 * i + 2][(axis + 2) % 3] += 1 + below(3);
    const bool flipped = below(2) != 0;
    mesh.Triangles.push_back({ 3 * i, 3 * i + 1 + flipped, 3 * i + 2 - flipped });
  }
  return mesh;
}

TriangleMesh BoxSoup(int n, std::mt19937_64& random)
{
  const auto below = [&](int end)
  { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    Point lower, upper;
    for (int axis = 0; axis < 3; ++axis)
    {
      lower[axis] = below(4);
      upper[axis] = lower[axis] + 1 + below(3);
    }
    const TriangleMesh box = Box(lower, upper);
    mesh = Joined(mesh, below(4) == 0 ? Flipped(box) : box);
  }
  return mesh;
}

TriangleMesh Assembly(int n, std::mt19937_64& random)
{
  const auto quarters = [&] { return 0.25 * static_cast<double>(random() % 9); };
  const TriangleMesh parts[] = { Box({ -0.5, -0.1, -0.2 }, { 0.5, 0.1, 0.2 }),
    Torus(0.5, 0.15, 24, 12), Sphere(2) };
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    const TriangleMesh& part = parts[random() % 3];
    const double scale = 0.5 + 0.05 * static_cast<double>(random() % 10);
    const double x = quarters(), y = quarters(), z = quarters();
    mesh = Joined(mesh, Moved(part, { x, y, z }, scale));
  }
  return mesh;
}

TriangleMesh Discs(int n, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> place(0.0, 4.0), size(0.5, 2.0);
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    const int axis = static_cast<int>(random() % 3), corners = 5 + static_cast<int>(random() % 16);
    const double height = static_cast<double>(random() % 5);
    const double u = place(random), v = place(random), radius = size(random);
    TriangleMesh disc;
    const auto add = [&](double x, double y)
    {
      Point& p = disc.Points.emplace_back();
      p[axis] = height;
      p[(axis + 1) % 3] = u + x;
      p[(axis + 2) % 3] = v + y;
    };
    add(0.0, 0.0);
    for (int k = 0; k < corners; ++k)
    {
      const double angle = 2.0 * M_PI * k / corners;
      add(radius * std::cos(angle), radius * std::sin(angle));
      disc.Triangles.push_back({ 0, 1 + k, 1 + (k + 1) % corners });
    }
    mesh = Joined(mesh, disc);
  }
  return mesh;
}

TriangleMesh Doubled(const TriangleMesh& mesh, double noise, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> off(-noise, noise);
  TriangleMesh other = mesh;
  for (Point& p : other.Points)
  {
    for (double& coordinate : p)
    {
      coordinate += off(random);
    }
  }
  return Joined(mesh, other);
}

TriangleMesh NearlyEqualSpheres()
{
  std::mt19937_64 random(1);
  return Doubled(Sphere(1), 1e-13, random);
}

RandomModel MakeRandom(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> unit;
  RandomModel model;
  const int parts = std::uniform_int_distribution<int>(1, 4)(random);
  for (int i = 0; i < parts; ++i)
  {
    bool closed = true;
    TriangleMesh part = RandomPart(random, closed);
    if (closed && unit(random) < 0.2)
    {
      part = Flipped(part);
    }
    const std::array<Point, 3> axes = RandomRotation(random);
    const double scale = 0.3 + 0.7 * unit(random);
    const Point center = { 2 * unit(random), 2 * unit(random), 2 * unit(random) };
    for (Point& p : part.Points)
    {
      p = { scale * carving::Dot(axes[0], p) + center[0],
        scale * carving::Dot(axes[1], p) + center[1],
        scale * carving::Dot(axes[2], p) + center[2] };
    }
    model.Closed = model.Closed && closed;
    model.Mesh = Joined(model.Mesh, part);
  }
  return model;
}

} // namespace models
