#include "declared_techniques.h"

#include <fstream>
#include <sstream>

namespace permgen {
namespace {

/// The words of a line; anything else than letters, digits and underscores separates them.
std::vector<std::string> words_of(std::string line) {
    for (char& c : line)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') c = ' ';
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

}  // namespace

std::vector<DeclaredTechnique> declared_techniques(const std::string& path) {
    std::vector<std::string> axes;
    std::vector<DeclaredTechnique> techniques;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::vector<std::string> words = words_of(line);
        for (std::size_t i = 0; i + 2 < words.size(); ++i)
            if (words[i] == "uniform" && words[i + 1] == "bool") axes.push_back(words[i + 2]);
        if (!line.starts_with("SLICE_TECHNIQUE(")) continue;
        DeclaredTechnique& technique = techniques.emplace_back();
        technique.name = words.at(1);
        for (std::size_t axis = 0; axis < axes.size(); ++axis)
            technique.switches.emplace_back(axes[axis], words.at(2 + axis) == "true");
    }
    return techniques;
}

}  // namespace permgen
