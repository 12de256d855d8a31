#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/gl_calls.h"

namespace pipeline {
namespace {

// The written program prints, this one does not: the architecture test tells them apart by the
// name that stands without its bracket here.
constexpr std::string_view kHead = R"(
#include <GL/gl.h>
#include <stdio.h>

/* OpenGL keeps its first error until it is asked for it, and goes on as if the call had not been.
   Asking after each step tells where it happened. */
static void checkError(const char *step)
{
    const char *what = "another error";
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_INVALID_ENUM) what = "GL_INVALID_ENUM: a name that the function does not take";
    if (error == GL_INVALID_VALUE) what = "GL_INVALID_VALUE: a number out of range";
    if (error == GL_INVALID_OPERATION) what = "GL_INVALID_OPERATION: not allowed here, or no context";
    if (error == GL_STACK_OVERFLOW) what = "GL_STACK_OVERFLOW: too many glPushMatrix";
    if (error == GL_STACK_UNDERFLOW) what = "GL_STACK_UNDERFLOW: a glPopMatrix too many";
    if (error == GL_OUT_OF_MEMORY) what = "GL_OUT_OF_MEMORY";
    fprintf)"
                                   R"((stderr, "OpenGL, %s: %s\n", step, what);
}

void drawScene(void)
{
)";

// Safe in a comment and in a string of C: names of objects and files may hold anything.
std::string plain(std::string_view words) {
    std::string text;
    for (const char c : words) {
        const bool harmless = c >= ' ' && c <= '~' && c != '*' && c != '"' && c != '\\' && c != '%' && c != '?';
        text += harmless ? c : '_';
    }
    return text;
}

std::string joined(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : ", ") + shortestText(number);
    return text;
}

// Calls between glBegin and glEnd stand one step further in.
std::string indent(const GlCall& call) {
    return call.function == "glNormal3d" || call.function == "glVertex3d" ? "        " : "    ";
}

}  // namespace

std::string toC(const GlCall& call) {
    std::string arguments;
    const std::string_view between = call.function == "glClear" ? " | " : ", ";
    for (const std::string_view name : call.names) {
        if (!arguments.empty()) arguments += between;
        arguments += name;
    }
    if (!call.numbers.empty()) {
        if (!arguments.empty()) arguments += ", ";
        const bool array = call.function.ends_with("v") || call.function == "glLoadMatrixd";
        if (array) arguments += call.function == "glLoadMatrixd" ? "(const GLdouble[]){" : "(const GLfloat[]){";
        arguments += joined(call.numbers);
        if (array) arguments += '}';
    }
    return fmt::format("{}({});", call.function, arguments);
}

Result<std::uint64_t> writeGlC(const Frame& frame, const std::filesystem::path& file) {
    const auto calls = glCalls(frame);
    if (!calls) return calls.errors();
    const Settings& settings = frame.scene().settings;
    ByteFile out(file);
    out.write(
        fmt::format("/* {}, drawn by fixed-function OpenGL 1.1: the calls that Shadescope {} matches.\n"
                    "   Call drawScene() with a compatibility context of {} x {} pixels that has a depth buffer.\n"
                    "   C99; link with -lGL. */\n",
                    plain(frame.scene().name), programVersion(), settings.width, settings.height));
    out.write(kHead);
    std::string step;
    for (const GlCall& call : *calls) {
        if (!call.comment.empty()) {
            if (!step.empty()) out.write(fmt::format("    checkError(\"{}\");\n\n", step));
            step = plain(call.comment);
            out.write(fmt::format("    /* {} */\n", step));
        }
        out.write(indent(call) + toC(call) + '\n');
    }
    out.write(fmt::format("    checkError(\"{}\");\n    glFlush();\n}}\n", step));
    return out.close();
}

}  // namespace pipeline
