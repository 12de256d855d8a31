#pragma once

namespace app {

class Document;
class ErrorList;

// Lists what the document could not do, as long as the list lives.
void reportFailures(Document& document, ErrorList& errors);

}  // namespace app
