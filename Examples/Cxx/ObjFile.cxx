// SPDX-License-Identifier: BSD-3-Clause
#include "ObjFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>

namespace
{

/** Of a corner v/t/n, the positions of t and n. */
constexpr const char* Kinds[] = { "texture coordinate", "normal" };

using Counts = std::array<long, std::size(Kinds)>;

constexpr const char* Blank = " \t\r";

/**
 * Reads a file line by line, without a byte order mark and comments behind other words, and with
 * continued lines joined.
 */
class LineReader
{
public:
  explicit LineReader(const std::string& fileName)
    : In(fileName)
  {
  }

  /** Returns false at the end of the file. */
  bool Read(std::string& line)
  {
    line.clear();
    bool continues = true;
    bool isRead = false;
    for (std::string part; continues && std::getline(this->In, part); isRead = true)
    {
      const std::string mark = "\xEF\xBB\xBF";
      const bool isMarked = this->Number++ == 0 && part.compare(0, mark.size(), mark) == 0;
      part.erase(0, isMarked ? mark.size() : 0);
      part.erase(part.find_last_not_of('\r') + 1);
      const std::size_t comment = part.find('#');
      const bool endsEarly = comment != part.npos && comment > 0;
      part.erase(endsEarly ? comment : part.size());
      continues = !part.empty() && part.back() == '\\';
      part.erase(part.size() - (continues ? 1 : 0));
      this->Unusual = this->Unusual || isMarked || endsEarly || continues;
      line += part;
    }
    return isRead;
  }

  /** The number of lines so far. */
  long GetNumber() const
  {
    return this->Number;
  }
  bool IsUnusual() const
  {
    return this->Unusual;
  }

private:
  std::ifstream In;
  long Number = 0;
  bool Unusual = false;
};

/** Takes the next word from a line; an empty one at its end. */
std::string_view TakeWord(std::string_view& line)
{
  line.remove_prefix(std::min(line.find_first_not_of(Blank), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(Blank));
  line.remove_prefix(word.size());
  return word;
}

/**
 * Reads what a corner refers to behind its slashes; 0 if nothing. Returns whether there is a number
 * behind the last slash.
 */
bool ReadReferences(std::string_view corner, Counts& references)
{
  references = {};
  std::size_t slash = corner.find('/');
  bool isComplete = true;
  for (long& reference : references)
  {
    if (slash != corner.npos)
    {
      std::from_chars(corner.data() + slash + 1, corner.data() + corner.size(), reference);
      isComplete = reference != 0;
      slash = corner.find('/', slash + 1);
    }
  }
  return isComplete;
}

/** Checks the faces of a file line by line. */
class FaceCheck
{
public:
  void Add(std::string_view line, long number)
  {
    this->Line = number;
    const std::string_view keyword = TakeWord(line);
    this->Seen[0] += keyword == "vt";
    this->Seen[1] += keyword == "vn";
    if (keyword == "f" && this->Mistake.empty())
    {
      this->AddFace(line);
    }
  }

  /** At the end of the file: an empty string, or a mistake. */
  std::string GetMistake() const
  {
    std::string mistake = this->Mistake;
    for (std::size_t kind = 0; mistake.empty() && kind < std::size(Kinds); ++kind)
    {
      if (this->Greatest[kind] > this->Seen[kind])
      {
        mistake = "line " + std::to_string(this->LineOfGreatest[kind]) + " has a face with " +
          Kinds[kind] + " " + std::to_string(this->Greatest[kind]) + " of " +
          std::to_string(this->Seen[kind]);
      }
    }
    return mistake;
  }

private:
  void AddFace(std::string_view corners)
  {
    int count = 0;
    for (std::string_view corner; !(corner = TakeWord(corners)).empty(); ++count)
    {
      Counts references;
      if (!ReadReferences(corner, references))
      {
        this->SetMistake("has no number behind a slash");
      }
      for (std::size_t kind = 0; kind < std::size(Kinds); ++kind)
      {
        const long reference = references[kind];
        if (reference < 0) // VTK 9.3's reader crashes on it
        {
          this->SetMistake("has a face with " + std::string(Kinds[kind]) + " " +
            std::to_string(reference) + ", counted backward");
        }
        if (reference > this->Greatest[kind])
        {
          this->Greatest[kind] = reference;
          this->LineOfGreatest[kind] = this->Line;
        }
      }
    }
    if (count < 3)
    {
      this->SetMistake("has a face with fewer than three corners");
    }
  }

  void SetMistake(const std::string& mistake)
  {
    this->Mistake = "line " + std::to_string(this->Line) + " " + mistake;
  }

  long Line = 0;
  Counts Seen = {}; ///< up to this line
  Counts Greatest = {}, LineOfGreatest = {};
  std::string Mistake; ///< one that does not depend on the lines to come
};

/** Copies a face with its vertices alone, unless there are fewer than three. */
void CopyFace(std::string_view corners, std::ostream& out)
{
  std::string face = "f";
  int count = 0;
  for (std::string_view corner; !(corner = TakeWord(corners)).empty(); ++count)
  {
    face.append(" ").append(corner.substr(0, corner.find('/')));
  }
  out << (count < 3 ? "" : face);
}

} // namespace

ObjFile::Content ObjFile::Check(const std::string& fileName)
{
  FaceCheck check;
  LineReader in(fileName);
  for (std::string line; in.Read(line);)
  {
    check.Add(line, in.GetNumber());
  }
  return { check.GetMistake(), in.IsUnusual() };
}

void ObjFile::Copy(const std::string& fileName, std::ostream& out)
{
  LineReader in(fileName);
  for (std::string line; in.Read(line);)
  {
    out << line << '\n';
  }
}

void ObjFile::CopyWithoutAttributes(const std::string& fileName, std::ostream& out)
{
  LineReader in(fileName);
  for (std::string line; in.Read(line); out << '\n')
  {
    std::string_view rest = line;
    const std::string_view keyword = TakeWord(rest);
    if (keyword == "f")
    {
      CopyFace(rest, out);
    }
    else if (keyword != "vt" && keyword != "vn")
    {
      out << line;
    }
  }
}
