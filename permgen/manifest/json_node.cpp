#include "json_node.h"

#include <limits>

#include "fault.h"

namespace permgen {

void JsonNode::fail(const std::string& what) const {
    throw Fault{file_ + ": " + (place_.empty() ? "" : place_ + ": ") + what + "; write it again with permgen compile"};
}

bool JsonNode::has(std::string_view field) const {
    return json_->is_object() && json_->contains(field);
}

JsonNode JsonNode::operator[](std::string_view field) const {
    if (!json_->is_object()) fail("an object was expected, and this is " + std::string(json_->type_name()));
    const auto found = json_->find(field);
    if (found == json_->end()) fail("the field '" + std::string(field) + "' is missing");
    return {*found, file_, (place_.empty() ? "" : place_ + ".") + std::string(field)};
}

std::vector<JsonNode> JsonNode::items() const {
    if (!json_->is_array()) fail("an array was expected, and this is " + std::string(json_->type_name()));
    std::vector<JsonNode> nodes;
    nodes.reserve(json_->size());
    for (std::size_t i = 0; i < json_->size(); ++i)
        nodes.emplace_back((*json_)[i], file_, place_ + "[" + std::to_string(i) + "]");
    return nodes;
}

std::string JsonNode::text() const {
    if (!json_->is_string()) fail("a text was expected, and this is " + std::string(json_->type_name()));
    return json_->get<std::string>();
}

std::uint32_t JsonNode::number() const {
    if (!json_->is_number_unsigned() || json_->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
        fail("a whole number from 0 to 4294967295 was expected, and this is " + json_->dump());
    return json_->get<std::uint32_t>();
}

bool JsonNode::truth() const {
    if (!json_->is_boolean()) fail("true or false was expected, and this is " + json_->dump());
    return json_->get<bool>();
}

}  // namespace permgen
