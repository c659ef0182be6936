// The page of failures: one folder for each failing comparison, and one index.html made of all of them.
//
//   FOLDER/index.html                         every failure, pictures side by side; one self-contained file
//   FOLDER/entries/KEY/entry.json             the failed check, the figures, and the command to repeat it
//   FOLDER/entries/KEY/image.exr, .png        the drawn picture
//   FOLDER/entries/KEY/expected.exr, .png     the expected picture, if known
//   FOLDER/entries/KEY/difference.exr, .png   |image - expected|
//
// Several processes may report into one folder at a time: a lock is held while an entry and the page are
// written, and readers never see a partial page.
#pragma once

#include <rig/image.h>

#include <string>
#include <utility>
#include <vector>

namespace tyndall::rig {

/// Identifies the comparison: the four together are unique in a folder. `pass` may be empty.
struct Subject {
    std::string effect, technique, pass;
    std::string check;  ///< "golden", "oracle, seen from the side"
};

struct Failure {
    Subject subject;
    std::vector<std::pair<std::string, std::string>> constants;  ///< {"bCookie", "true"}: the permutation's switches
    std::string reason;                                          ///< one sentence
    std::string command;                                         ///< a shell command that runs this again
};

/// Adds or replaces the failure's entry and rebuilds the page. Either image may be null.
/// Errors: the folder cannot be written, or its index.html is not such a page; nothing is changed then.
Result<void> reportFailure(const std::string& folder, const Failure& failure, const Image* image,
                           const Image* expected);

/// Removes the entry of this comparison, and rebuilds the page if there was one. Makes no folder.
Result<void> reportPass(const std::string& folder, const Subject& subject);

/// Removes the entries of techniques that the effect no longer has, and rebuilds the page if there were any.
/// Makes no folder.
Result<void> reportTechniques(const std::string& folder, const std::string& effect,
                              const std::vector<std::string>& techniques);

/// The folder name of the subject's entry: readable, and different for different subjects.
std::string entryKey(const Subject& subject);

/// `words` as one line for a POSIX shell, quoted where needed.
std::string shellCommand(const std::vector<std::string>& words);

}  // namespace tyndall::rig
