#pragma once
#include <QString>

namespace app {

class Document;

// The file that the document's scene can be saved to again and nothing is lost: the one it comes from, if it is the
// user's, can be written, and still holds what this program wrote there, word for word. Empty where it is another: a
// built-in scene, a format that is only read, a file with comments of somebody's own or changed meanwhile.
QString ownFile(const Document& document);

}  // namespace app
