// The effects that tests draw with: the runtime's built-in ones, or builds in the folder that the environment variable
// TYNDALL_EFFECTS names. This allows tests of a faulty shader without building C++.
#pragma once

#include <permgen/tables.h>

#include <string>

namespace tyndall::test {

/// The effect of NAME.fx.json in that folder, valid until the process ends; null if the variable is not set or the
/// folder lacks that manifest. Throws if there is no such folder, or the manifest cannot be loaded.
const permgen::Effect* effectUnderTest(const std::string& name);

}  // namespace tyndall::test
