#pragma once
#include <QString>
#include <vector>

#include "base/result.h"

namespace ostraka::ui {

/// What core says, in the person's language: the translation of the template, with the values as
/// the language writes them. translations/messages.py finds the templates of core for translators,
/// in the context "ostraka::Error". Words without a template stay as they are.
QString wordsOf(const Message& message);
QStringList listOf(const std::vector<Message>& messages);
/// A line each.
QString wordsOf(const std::vector<Message>& messages);
/// By commas, the first `most` of them and an ellipsis for the others.
QString firstOf(const QStringList& names, qsizetype most);
/// What a person reads of an error: where, what, and what to do.
QString sentenceOf(const Error& error);

}  // namespace ostraka::ui
