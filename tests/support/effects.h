// The effects that tests draw with: those built into the runtime, or builds of them that the environment
// variable TYNDALL_EFFECTS names a folder of. So a fault in a shader can be tested for without building C++.
#pragma once

#include <permgen/tables.h>

#include <string>

namespace tyndall::test {

/// The effect of NAME.fx.json in that folder, for as long as the process lives; null where the variable is not
/// set or the folder lacks that manifest. Throws where there is no such folder, or the manifest cannot be loaded.
const permgen::Effect* effectUnderTest(const std::string& name);

}  // namespace tyndall::test
