#pragma once
#include <string>
#include <string_view>

// What pages about a class are put together from.

namespace lessons {

// A whole page in HTML 5. The heading is escaped, the body is HTML.
std::string classPage(std::string_view title, std::string_view heading, const std::string& body);
std::string classSection(std::string_view heading, const std::string& body);
// A table with its head, in HTML; empty without rows.
std::string classTable(std::string_view head, const std::string& rows);
// "67 %", and the same with a bar before it.
std::string percent(std::size_t part, std::size_t all);
std::string shareBar(std::size_t part, std::size_t all);

}  // namespace lessons
