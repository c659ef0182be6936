#include "front/parse_numthreads.h"

#include "front/parse_technique.h"

namespace permgen {

bool begins_numthreads(const ParseCursor& cursor) {
    return cursor.is("[") && same_word(cursor.peek(1).text, "numthreads");
}

ThreadGroup parse_numthreads(ParseCursor& cursor) {
    ThreadGroup group;
    const std::size_t begin = cursor.at;
    cursor.take();
    group.at = cursor.take().at;
    cursor.expect("(", "after 'numthreads'");
    do group.sizes.push_back(cursor.skip_to(",)", "[numthreads(...)]"));
    while (cursor.take_if(","));
    cursor.expect(")", "after the sizes of [numthreads(...)]");
    cursor.expect("]", "after [numthreads(...)");
    cursor.drop({begin, cursor.at});
    return group;
}

}  // namespace permgen
