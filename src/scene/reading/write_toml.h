#pragma once
#include <string>

#include "scene/reading/scene_desc.h"

namespace flatray {

/// A description as TOML that reads back as the same description: the same tables, keys and
/// entries in the same order, tables of several kinds by turns as they were (but that single values,
/// and short tables before all lists of tables, come first), the same strings, the same decimals.
/// Numbers are the shortest way to write their decimal, hexadecimal and underscores gone; of a
/// decimal too long for TOML's reader, and beyond 10^+-100000, their double. Bytes of strings that
/// are not UTF-8 are taken as Latin-1. Comments are not part of a description.
///
/// Gives   lines of about 100 columns where the content allows it; written again, the same bytes.
/// Cost    linear in the values times their nesting.
std::string write_toml(const SceneDesc& desc);

/// The shortest TOML number of the same decimal, or of the same double where that has more than the
/// 128 characters that are read of a number.
std::string shortest_number(std::string_view literal);

}  // namespace flatray
