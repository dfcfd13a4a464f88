#pragma once
#include <string>

namespace morphgrid {

/// A Markdown document with other lines between those that read `<!-- begin NAME -->` and
/// `<!-- end NAME -->`; all else is kept. content: whole lines. Throws InputError when the document
/// has no such pair of lines.
std::string withBlock(const std::string& document, const std::string& name,
                      const std::string& content);

}  // namespace morphgrid
