/**
 * @file ReadingReport.h
 * @brief Reports what a reader decided, corrected or dropped, as notes in the field data and one
 * warning.
 */
#ifndef isthmus_ReadingReport_h
#define isthmus_ReadingReport_h

#include "Molecules/Macromolecule.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace isthmus
{

/**
 * Collects sentences and counts while a text is read. All of them become notes (field data Notes).
 * Those that affect the result are combined in one warning, so that a file with many faults does
 * not cause many messages.
 *
 * Counts with the same text are summed: Count("Unreadable CONECT records, dropped", "line 7") twice
 * becomes "Unreadable CONECT records, dropped: 2 (first: line 7).".
 */
class ReadingReport
{
public:
  /// For reference only.
  void Note(std::string sentence) { this->Sentences.push_back({ std::move(sentence), false }); }

  /// Also part of the warning.
  void Warn(std::string sentence) { this->Sentences.push_back({ std::move(sentence), true }); }

  /// A part of the warning: what happened, how often, and where first.
  void Count(const std::string& what, const std::string& where, std::size_t times = 1)
  {
    if (times == 0)
    {
      return;
    }
    for (Counted& counted : this->Counts)
    {
      if (counted.What == what)
      {
        counted.Times += times;
        return;
      }
    }
    this->Counts.push_back({ what, where, times });
  }

  /// Ends the report: adds the notes and at most one warning to `molecule`.
  void AddTo(Macromolecule& molecule) const
  {
    std::string warning;
    const auto add = [&](const std::string& sentence, bool isWarning)
    {
      molecule.Notes.push_back(sentence);
      if (isWarning)
      {
        warning += (warning.empty() ? "" : " ") + sentence;
      }
    };
    for (const Message& sentence : this->Sentences)
    {
      add(sentence.Text, sentence.IsWarning);
    }
    for (const Counted& counted : this->Counts)
    {
      add(counted.What + ": " + std::to_string(counted.Times) +
          (counted.Where.empty() ? "." : " (first: " + counted.Where + ")."),
        true);
    }
    if (!warning.empty())
    {
      molecule.Warnings.push_back(warning);
    }
  }

private:
  struct Message
  {
    std::string Text;
    bool IsWarning;
  };

  struct Counted
  {
    std::string What;
    std::string Where;
    std::size_t Times;
  };

  std::vector<Message> Sentences;
  std::vector<Counted> Counts;
};

}

#endif
