// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Binary archives, which a function visits alike for writing and for reading.
 */
#ifndef carving_Archive_h
#define carving_Archive_h

#include "Core/Mesh/LargePages.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <type_traits>

namespace carving
{

/** Writes values one after the other, in the byte order of this machine. */
class ArchiveWriter
{
public:
  ArchiveWriter(std::ostream& out, const char (&magic)[8])
    : Out(out)
  {
    this->Out.write(magic, sizeof(magic));
  }

  template <class T>
  void Value(const T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "raw bytes are written");
    this->Out.write(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  template <class Container>
  void Array(const Container& values)
  {
    static_assert(
      std::is_trivially_copyable<typename Container::value_type>::value, "raw bytes are written");
    this->Value(static_cast<std::uint64_t>(values.size()));
    this->Out.write(reinterpret_cast<const char*>(values.data()),
      static_cast<std::streamsize>(values.size() * sizeof(typename Container::value_type)));
  }

private:
  std::ostream& Out;
};

/** Reads what an ArchiveWriter wrote, never past the end. After a failure, arrays are empty. */
class ArchiveReader
{
public:
  ArchiveReader(const char* data, std::size_t size)
    : At(data)
    , Left(size)
  {
  }

  bool Magic(const char (&magic)[8])
  {
    char found[8] = {};
    this->Value(found);
    return this->Good && std::memcmp(found, magic, sizeof(found)) == 0;
  }

  template <class T>
  void Value(T& value)
  {
    if (this->Take(sizeof(T)))
    {
      std::memcpy(&value, this->At - sizeof(T), sizeof(T));
    }
  }

  template <class Container>
  void Array(Container& values)
  {
    using T = typename Container::value_type;
    std::uint64_t count = 0;
    this->Value(count);
    values.clear();
    if (count <= this->Left / sizeof(T) && this->Take(count * sizeof(T)) && count > 0)
    {
      ReserveLarge(values, count);
      values.resize(count);
      std::memcpy(&values[0], this->At - count * sizeof(T), count * sizeof(T));
    }
    else if (count > 0)
    {
      this->Good = false;
    }
  }

  /** Whether all data were read and none remain. */
  bool Complete() const
  {
    return this->Good && this->Left == 0;
  }

private:
  bool Take(std::size_t bytes)
  {
    this->Good = this->Good && bytes <= this->Left;
    if (this->Good)
    {
      this->At += bytes;
      this->Left -= bytes;
    }
    return this->Good;
  }

  const char* At;
  std::size_t Left;
  bool Good = true;
};

} // namespace carving

#endif
