#include "lower/group_size.h"

#include <bit>

#include "d3d9/profiles.h"
#include "front/parse_cursor.h"
#include "front/report.h"
#include "lower/lower_arguments.h"

namespace permgen {

std::optional<std::array<std::uint32_t, 3>> group_size(const ParsedEffect& effect, const Sources& sources,
                                                       const Function& entry, std::string_view profile,
                                                       Diagnostics& diagnostics) {
    const auto fail = [&](Location at, std::string message) {
        report_error(diagnostics, "PG029", sources.place(at), std::move(message));
        return std::nullopt;
    };
    const std::string name(entry.name);
    if (!entry.threads)
        return fail(entry.at, "compute shader '" + name +
                                  "' has no thread group; write [numthreads(X, Y, Z)] in front of it, such as "
                                  "[numthreads(8, 8, 1)]");
    if (entry.threads->sizes.size() != 3)
        return fail(entry.threads->at, "[numthreads] takes three sizes, not " +
                                           std::to_string(entry.threads->sizes.size()) +
                                           "; write [numthreads(X, Y, Z)]");
    const d3d9::GroupLimits limits = d3d9::group_limits(profile);
    const std::string profiles(limits.profiles);
    std::array<std::uint32_t, 3> size{};
    std::uint64_t threads = 1;
    for (std::size_t axis = 0; axis < size.size(); ++axis) {
        const TokenRange range = entry.threads->sizes[axis];
        constexpr std::string_view names[] = {"the x size of [numthreads]", "the y size of [numthreads]",
                                              "the z size of [numthreads]"};
        const std::string which(names[axis]);
        const std::string allowed =
            "; write a whole number from 1 to " + std::to_string(limits.size[axis]) + ", as " + profiles + " allows";
        if (range.empty()) return fail(entry.threads->at, which + " is missing" + allowed);
        const Location at = effect.tokens[range.begin].at;
        const std::string written = "'" + text_of(effect, range) + "'";
        std::string problem;
        const auto bits = literal_bits(std::span<const Token>(effect.tokens).subspan(range.begin, range.size()),
                                       ScalarType::Int, problem);
        if (!bits)
            return fail(at, which + ", " + written + ", " + (problem.empty() ? "is not a literal" : problem) + allowed);
        const auto value = std::bit_cast<std::int32_t>(*bits);
        if (value < 1 || static_cast<std::uint32_t>(value) > limits.size[axis])
            return fail(at, which + " is " + written + allowed);
        size[axis] = static_cast<std::uint32_t>(value);
        threads *= size[axis];
    }
    if (threads > limits.threads)
        return fail(entry.threads->at, "[numthreads] makes groups of " + std::to_string(threads) + " threads, and " +
                                           profiles + " allows " + std::to_string(limits.threads) +
                                           "; make a size smaller");
    return size;
}

}  // namespace permgen
