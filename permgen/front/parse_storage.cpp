#include "front/parse_storage.h"

#include "d3d9/storage_types.h"
#include "front/parse_declaration.h"

namespace permgen {
namespace {

constexpr std::size_t name_tokens = 5;

bool begins_image_format(const ParseCursor& cursor) {
    constexpr std::string_view words[name_tokens] = {"[", "[", "vk", "::", "image_format"};
    for (std::size_t i = 0; i < name_tokens; ++i)
        if (!cursor.peek(i).is(words[i])) return false;
    return true;
}

}  // namespace

bool begins_storage(const ParseCursor& cursor, std::size_t ahead) {
    const Token& next = cursor.peek(ahead + 1);
    return d3d9::find_storage_type(cursor.peek(ahead).text) && (next.is("<") || next.is_identifier());
}

std::optional<ImageFormatAttribute> parse_image_format(ParseCursor& cursor) {
    std::optional<ImageFormatAttribute> format;
    while (begins_image_format(cursor)) {
        const std::size_t begin = cursor.at;
        const Location at = cursor.peek(name_tokens - 1).at;
        cursor.at += name_tokens;
        if (format) cursor.fail("PG041", at, "[[vk::image_format(...)]] is given twice; remove one");
        cursor.expect("(", "after 'image_format'");
        const Token& name = cursor.take();
        if (name.kind != TokenKind::String)
            cursor.fail("PG041", name.at,
                        "expected the format's name in quotes, not " + quoted(name) +
                            "; write [[vk::image_format(\"rgba16f\")]]");
        format = ImageFormatAttribute{unquoted(name), name.at};
        for (const std::string_view bracket : {")", "]", "]"}) cursor.expect(bracket, "after the image format's name");
        cursor.drop({begin, cursor.at});
    }
    return format;
}

void parse_storages(ParseCursor& cursor, const std::optional<ImageFormatAttribute>& format) {
    const std::size_t begin = cursor.at;
    StorageResource first;
    first.format = format;
    first.type = cursor.take().text;
    const std::string type(first.type);
    if (d3d9::find_storage_type(type)->has_element) {
        cursor.expect("<", "with the element's type behind '" + type + "'");
        const Token& element = cursor.peek();
        if (element.is("unorm") || element.is("snorm"))
            cursor.fail("PG041", element.at,
                        quoted(element) + " is not supported in '" + type + "<...>'; write [[vk::image_format(\"rgba8" +
                            (element.is("snorm") ? "snorm" : "") + "\")]] " + type + "<float4>");
        if (element.is("row_major") || element.is("column_major"))
            cursor.fail("PG041", element.at,
                        quoted(element) + " is not supported in '" + type + "<...>'; write the plain type");
        first.element = parse_type(cursor);
        cursor.expect(">", "after the element's type of '" + type + "'");
    } else if (cursor.is("<")) {
        cursor.fail("PG041", cursor.peek().at, "'" + type + "' has no element type; remove '<...>'");
    }
    do {
        StorageResource storage = first;
        const Token& name = cursor.expect_identifier("the name of this " + type);
        storage.name = name.text;
        storage.at = name.at;
        if (cursor.is("["))
            cursor.fail("PG022", cursor.peek().at,
                        "arrays of " + type + " are not supported; declare each by its own name");
        Variable declarator;
        declarator.name = name.text;
        parse_declarator(cursor, declarator, ",;");
        if (!declarator.initializer.empty())
            cursor.fail("PG022", name.at,
                        "'" + std::string(name.text) + "' cannot have an initial value; fill it from the application");
        storage.range = {begin, cursor.at};
        cursor.effect.items.push_back({ItemKind::Storage, cursor.effect.storages.size(), 1, storage.range});
        cursor.effect.storages.push_back(std::move(storage));
    } while (cursor.take_if(","));
    cursor.expect(";", "after '" + std::string(cursor.effect.storages.back().name) + "'");
    cursor.drop({begin, cursor.at});
}

}  // namespace permgen
