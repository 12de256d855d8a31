#pragma once

namespace app {

class Document;
class ErrorList;

// Adds the document's failures to a list until it is destroyed.
void reportFailures(Document& document, ErrorList& errors);

}  // namespace app
