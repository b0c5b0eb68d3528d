// Reading a domain file (docs/domain-format.md).
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/domain/domain.h"

namespace triscope {

/// Reads and checks a domain file. The domain is simple, disjoint and oriented; every error says where it is and
/// what to do about it. A file that cannot be opened gives ErrorKind::no_input, a wrong one ErrorKind::bad_data.
Result<Domain> readDomain(const std::string& path);

/// The same for a text in memory; fileName goes into the domain and into messages.
Result<Domain> parseDomain(std::string_view json, const std::string& fileName);

}  // namespace triscope
