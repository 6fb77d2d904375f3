#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ostraka::store {

/// A lone half of a surrogate pair becomes bytes that isUtf8() refuses.
std::string fromUtf16(std::u16string_view text);
/// Composed (Unicode NFC), so that the same letters are the same bytes.
std::string composed(std::string_view text);
/// What must be unique: composed, then case-folded; É-1 and é-1 are the same.
std::string uniqueKey(std::string_view text);
/// What the codes of places and persons are told apart by: K 12, K12 and k12 are the same.
std::string codeKey(std::string_view text);
/// Letters and digits alone, small, without accents: "Épaisseur (max.)" is "epaisseurmax".
std::string plainKey(std::string_view text);
/// Orders 9 before 10 and A2 before A10, capitals with small letters. What people read as one
/// number has one key: leading zeros and which marks stand between its parts make no difference.
std::string sortKey(std::string_view text);
/// A file's name: letters, digits, '-', '.' and '_'; everything else becomes '_'. Never empty,
/// never hidden, no '%', no line break; a name that Windows keeps for a device, and one that ends
/// with '.', which it cannot hold, get a '_' more.
std::string slug(std::string_view text);
/// One component of a path that leads nowhere else and that everybody sees: the letters of slug(),
/// though not on any system. Whatever is deleted below a name is deleted below one of these.
bool isFolderName(std::string_view text);
/// Letters that nobody sees: they turn the direction of writing or take no room (U+200B to U+200F,
/// U+202A to U+202E, U+2066 to U+2069, U+FEFF). In a number they make two of what looks like one.
bool hasInvisible(std::string_view text);
/// Without white space at both ends.
std::string trimmed(std::string_view text);

}  // namespace ostraka::store
