#include "geometry/capacity.h"

#include <string>

namespace tyndall {

void throwCapacityExceeded(std::size_t capacity, const std::source_location& where) {
    throw CapacityExceeded(std::string(where.function_name()) + " adds to a container that already holds " +
                           std::to_string(capacity) + " entries, its capacity");
}

Error internalError(const CapacityExceeded& exceeded) {
    return {ErrorCode::Internal, std::string("internal: ") + exceeded.what() +
                                     "; this is a fault of the library: report it with the lights, the view "
                                     "and the surroundings that were given"};
}

}  // namespace tyndall
