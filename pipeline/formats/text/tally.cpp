#include "pipeline/formats/text/tally.h"

#include <fmt/format.h>

#include "pipeline/formats/text/text_scanner.h"

namespace pipeline {

std::string CaseTally::about() const { return fmt::format("{}:{}", m_file, m_line); }

void CaseTally::say(std::string_view noun, std::string_view which, std::string_view fate,
                    std::vector<Remark>& remarks) const {
    if (m_count == 0) return;
    const bool one = m_count == 1;
    remarks.push_back({about(), fmt::format("{} {}{}{}{} {} {}.", groupedDigits(m_count), noun, one ? "" : "s",
                                            which.empty() ? "" : " ", which, one ? "is" : "are", fate)});
}

}  // namespace pipeline
