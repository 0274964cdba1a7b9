// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/files.h"

#include "bind/evaluate.h"
#include "support/folder.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>

#include <sys/resource.h>

namespace candelabra {

namespace {

struct SaidWithFiles {
    std::string printed;
    std::string messages;  ///< a line each, with the help
};

/// The folder of a scene that runs several times, with the files that its runs have made.
struct SceneFolder : Folder {
    std::shared_ptr<MadeFiles> made = std::make_shared<MadeFiles>(std::string());
};

/// Runs a script whose files are in the folder.
SaidWithFiles said(const SceneFolder& folder, const std::string& script, const Limits& limits = {},
                   bool off_disk = false) {
    const std::string here = folder.path().string();
    SourceStore sources;
    Diagnostics diagnostics;
    FileAccess access({here}, {here});
    access.remembers(folder.made);
    Loader loader(scene_reader(access), here, {}, access);
    if (off_disk) loader.keep_off_disk();
    SaidWithFiles result;
    EvaluateOptions options;
    options.limits = limits;
    options.print = [&](std::string_view text) { result.printed += text; };
    const std::string whole =
        "#version 3.7; #macro P(vv) #debug concat(str(vv, 0, 0), \" \") #end\n";
    evaluate(sources, loader, sources.add(here + "/main.pov", whole + script), options,
             diagnostics);
    for (const Diagnostic& each : diagnostics.all())
        result.messages += each.message + (each.help.empty() ? "" : " | " + each.help) + "\n";
    return result;
}

}  // namespace

TEST_CASE("what is written can be read and included", "[files]") {
    const SceneFolder folder;
    const SaidWithFiles result = said(folder, R"(
        #fopen Out "numbers.txt" write #write(Out, 1, ",", <2, 3>) #fclose Out
        #fopen Out "numbers.txt" append #write(Out, ",4") #fclose Out
        #fopen In "numbers.txt" read
        #while (defined(In)) #read(In, V) #debug vstr(2, 0*x + V, ",", 0, 0) #debug " " #end
        #macro Value(Text)
            #fopen Code "code.inc" write #write(Code, "#declare Result = ", Text, ";") #fclose Code
            #include "code.inc"
            Result
        #end
        P(Value("1+1")) P(Value("3*3")))");
    CHECK(result.messages == "");
    CHECK(result.printed == "1,1 2,3 4,4 2 9 ");
    CHECK(folder.get("numbers.txt") == "1,<2,3> ,4");
}

TEST_CASE("a scene goes on without a page that it may not write", "[files]") {
    const SceneFolder folder;
    for (const std::string name : {"page.html", "makefile", "run.sh", "-rf.txt"}) {
        const SaidWithFiles result =
            said(folder, "#fopen Out \"" + name + "\" write #write(Out, 1) #fclose Out P(7)");
        CHECK(result.printed == "7 ");
        CHECK(result.messages.starts_with("a scene may not write `" + name + "` | `--allow-write "));
        CHECK_FALSE(std::filesystem::exists(folder / name));
    }
    CHECK(said(folder, "#fopen Out \"a.ini\" write P(7)").printed == "");
}

TEST_CASE("a run that changes nothing reads back what it has not written", "[files]") {
    const SceneFolder folder;
    CHECK(said(folder, "#fopen Out \"old.txt\" write #write(Out, \"7,\")").messages == "");
    const auto off_disk = [&](const std::string& script) {
        const SaidWithFiles result = said(folder, script, {}, true);
        return result.messages + result.printed;
    };
    CHECK(off_disk(R"x(
        #fopen Out "n.txt" write #write(Out, 1, ",", 2) #fclose Out
        #fopen In "n.txt" read #read(In, A, B) P(A) P(B) P(file_exists("n.txt"))
        #fopen Out "code.inc" write #write(Out, "P(5)") #fclose Out #include "code.inc"
        #fopen Out "code.inc" write #write(Out, "P(6)") #fclose Out #include "code.inc")x") ==
          "1 2 1 5 6 ");
    CHECK(off_disk(R"x(
        #fopen Out "old.txt" append #write(Out, "8") #fclose Out
        #fopen In "old.txt" read #read(In, A, B) P(A) P(B))x") == "7 8 ");
    CHECK(off_disk("#fopen Out \"../n.txt\" write").starts_with("a scene may not write"));
    CHECK(folder.get("old.txt") == "7,");
    CHECK_FALSE(std::filesystem::exists(folder / "n.txt"));
    CHECK_FALSE(std::filesystem::exists(folder / "code.inc"));
}

TEST_CASE("reading puts values into names and elements, and closes the file at its end",
          "[files]") {
    const SceneFolder folder;
    folder.put("d.txt", "1, \"two\", 3, 4");
    CHECK(said(folder, R"(#fopen F "d.txt" read #declare A = array[2] {0, 0}
        #read(F, A[1], B, C) P(A[1]) #debug B P(C) P(defined(F))
        #read(F, D, E) P(D) P(defined(E)) P(defined(F)) #fclose F)")
              .printed == "1 two3 1 4 0 0 ");
    folder.put("e.txt", "1,");
    CHECK(said(folder, R"(#fopen F "e.txt" read #read(F, B) P(defined(F)) #read(F, C)
        P(defined(C)) P(defined(F)))")
              .printed == "1 1 0 ");
}

TEST_CASE("a list that goes on in the next line is warned of, once a file", "[files]") {
    const SceneFolder folder;
    folder.put("d.txt", "1, 2, 3,\n4, 5,\n6, 7, 8\n9, 10, 11\n");
    const std::string warning =
        "this #read goes on in the next line of `d.txt` | read_csv(\"...\") reads tables, and "
        "reports short rows\n";
    const std::string open = "#fopen F \"d.txt\" read ";
    const std::string read = "#while (defined(F)) #read(F, A, B, C) #end ";
    CHECK(said(folder, open + read).messages == warning);
    CHECK(said(folder, open + read + open + read).messages == warning);
    CHECK(said(folder, open + "#while (defined(F)) #read(F, A) #end").messages == "");
    CHECK(said(folder, open + "#read(F, A, B, C) #read(F, A, B) #read(F, A, B, C)").messages == "");
    folder.put("d.txt", "1, 2,\n3, 4,\n");
    CHECK(said(folder, open + "#while (defined(F)) #read(F, A, B) #end").messages == "");
    folder.put("d.txt", "<1,\n2>, 3 4\n");
    CHECK(said(folder, open + "#while (defined(F)) #read(F, A, B, C) #end").messages == "");
}

TEST_CASE("wrong uses of files say what is wrong", "[files]") {
    const SceneFolder folder;
    folder.put("d.txt", "1, 2");
    struct Case {
        const char* script;
        const char* messages;
    };
    const Case cases[] = {
        {"#fopen F \"none.txt\" read", "there is no file `none.txt`\n"},
        {"#fopen F \"d.txt\" create",
         "a file is opened for read, write or append, not for `create`\n"},
        {"#fopen F 3 read", "#fopen takes the name of a file, but this is a number\n"},
        {"#declare F = 1; #fopen F \"d.txt\" read",
         "`F` is declared already | #undef it before, or choose another name\n"},
        {"#fopen F \"../x.txt\" write",
         "a scene may not write `../x.txt` | `--allow-write ..` allows it\n"},
        {"#fopen F \"none/x.txt\" write", "the file `none/x.txt` cannot be written\n"},
        {"#write(F, 1)",
         "no file is open as `F` | #fopen F \"...\" opens one; at its end it is closed\n"},
        {"#declare F = 1; #write(F, 1)", "`F` is a number and not an open file\n"},
        {"#fopen F \"d.txt\" read #write(F, 1)", "`d.txt` is open for reading\n"},
        {"#fopen F \"o.txt\" write #read(F, A)", "`o.txt` is open for writing\n"},
        {"#fopen F \"d.txt\" read #read(F, 1)",
         "#read puts values into names and elements of arrays, and this is neither\n"},
        {"#fopen F \"o.txt\" write #write(F, sphere { 0, 1 })",
         "numbers, vectors and strings can be written, but this is an object\n"},
        {"#fopen F \"o.txt\" write #write(F, uint8 \"a\")",
         "numbers, vectors and strings can be written, but this is a string where binary numbers "
         "are written\n"},
        {"#read()", "#read needs an open file and names to read into\n"},
        {"#write()", "#write needs an open file and values\n"},
        {"#write(1, 2)", "the name of an open file is wanted first\n"},
    };
    for (const Case& c : cases) {
        INFO(c.script);
        CHECK(said(folder, c.script).messages == c.messages);
    }
}

TEST_CASE("a scene cannot write without end", "[files]") {
    const SceneFolder folder;
    Limits limits;
    limits.written_bytes = 10'000;
    const SaidWithFiles result = said(
        folder, "#fopen F \"o.txt\" write #while (1) #write(F, \"0123456789abcdef\") #end", limits);
    CHECK(result.messages ==
          "this scene has written more than 10000 bytes, which is the limit | "
          "--limit-written, in megabytes, raises it\n");
    CHECK(folder.get("o.txt").size() < 11'000);
}

TEST_CASE("what does not get to the disk is said, also of a file that is never closed", "[files]") {
    const SceneFolder folder;
    // Simulates a disk that is full after a thousand bytes.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    const rlimit small{1000, before.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const std::string open = "#fopen F \"o.txt\" write #for (I, 1, 999) #write(F, I, \",\") #end ";
    const std::string lost = "not everything could be written to `o.txt`\n";
    std::vector<std::string> messages;
    for (const char* end : {"", "#undef F", "#fclose F", "#macro A() #fclose F #end A()"})
        messages.push_back(said(folder, open + end).messages);
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, SIG_DFL);
    for (const std::string& each : messages) CHECK(each == lost);
    CHECK(said(folder, open).messages.empty());
}

TEST_CASE("a scene writes no settings, and over nothing that others have made", "[files]") {
    const SceneFolder folder;
    folder.put("notes.txt", "mine");
    folder.put("Other.POV", "mine");
    folder.put("lib.inc", "mine");
    const auto write = [&](const std::string& name, const char* how, bool off_disk) {
        return said(folder, "#fopen F \"" + name + "\" " + how + " #write(F, \"x\") #fclose F", {},
                    off_disk)
            .messages;
    };
    for (const bool off_disk : {true, false}) {
        for (const char* how : {"write", "append"})
            for (const std::string name :
                 {"candelabra.ini", "CANDELABRA.INI", "new.Ini", "sub/../a.ini", "a.ini.", "a.ini ",
                  "p.png.state.exr", "notes.txt", "Other.POV", "lib.inc", "./lib.inc"}) {
                INFO(name << " " << how);
                CHECK(
                    write(name, how, off_disk).starts_with("a scene may not write `" + name + "`"));
            }
        CHECK(write("new.txt", "write", off_disk).empty());
        CHECK(write("new.txt", "append", off_disk).empty());
        CHECK(write("new.inc", "write", off_disk).empty());
        CHECK(write("new.pov", "write", off_disk).empty());
    }
    CHECK(folder.get("notes.txt") + folder.get("Other.POV") + folder.get("lib.inc") ==
          "mineminemine");
    CHECK(folder.get("new.txt") == "xx");
    CHECK_FALSE(std::filesystem::exists(folder / "candelabra.ini"));
}

}  // namespace candelabra
