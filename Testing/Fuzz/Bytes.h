// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The bytes of a fuzzer as a source of decisions.
 */
#ifndef Bytes_h
#define Bytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>

/** Returns zeros after the last byte. */
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : At(data)
    , Left(size)
  {
  }

  /** 0 to n - 1, for n up to 256. */
  int Below(int n)
  {
    std::uint8_t byte = 0;
    this->Take(&byte, 1);
    return byte % n;
  }

  /** A bit; eight of them take a byte. */
  bool Bit()
  {
    if (this->BitsLeft == 0)
    {
      this->Bits = this->Below(256);
      this->BitsLeft = 8;
    }
    --this->BitsLeft;
    return (this->Bits >> this->BitsLeft & 1) != 0;
  }

  /** Any double, also a huge, denormal or infinite one or NaN. */
  double Double()
  {
    double value = 0.0;
    this->Take(&value, sizeof(value));
    return value;
  }

  const char* Data() const
  {
    return reinterpret_cast<const char*>(this->At);
  }
  std::size_t Size() const
  {
    return this->Left;
  }

private:
  void Take(void* to, std::size_t size)
  {
    if (size <= this->Left)
    {
      std::memcpy(to, this->At, size);
      this->At += size;
      this->Left -= size;
    }
  }

  const std::uint8_t* At;
  std::size_t Left;
  int Bits = 0;
  int BitsLeft = 0;
};

#endif
