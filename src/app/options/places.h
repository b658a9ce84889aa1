#pragma once
#include <filesystem>
#include <span>

#include "app/verb.h"

namespace flatray {

/// What the operand of that number is: "SCENE", of "[SCENE...]" too, whose last word repeats.
std::string operand_word(const Verb& verb, std::size_t index);

/// Whether what stands for a value - "SCENE", "PATTERN", "OUT.png" - is the name of a file or
/// folder.
bool names_path(std::string_view metavar);

/// Whether --root is an option of the verb's own, which then finds all in that folder.
bool has_own_root(std::span<const Option> own);

/// With --root: that the files and folders named by operands and options, and where output goes
/// that none of them names, lie in that folder or beneath it. To the problems of the arguments:
/// each that does not.
void check_root(const Verb& verb, Arguments& arguments);

/// That files lie in the folder that --root says, or beneath it, links on the way followed. Error   Trouble::usage,
/// each that does not.
Result<void> expect_in_root(const std::string& root, std::span<const std::filesystem::path> files);

/// With --sandbox: leaves open for reading what the command line names and, of scenes, what they
/// may refer to, besides the program's own modules and the libraries of the system; for writing the
/// folders named for output, which are made. Error that of enter_sandbox and of folders.
Result<void> enter_sandbox(const Verb& verb, const Arguments& arguments);

}  // namespace flatray
