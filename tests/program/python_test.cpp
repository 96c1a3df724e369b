// SPDX-License-Identifier: MIT
// The Python package and its notebook (docs/python.md), run with a Python that has their modules.
#include <gtest/gtest.h>

#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace python_test {

// The first Python with these modules; "" if none has them.
std::string pythonWith(const std::string& modules) {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (runLine(fmt::format("{} -c 'import {}'", python, modules)).exit_code == 0) return python;
  return "";
}

Outcome runPython(const std::string& python, const std::string& arguments) {
  return runLine(fmt::format("cd '{0}' && env PYTHONPATH='{0}/python' STROBE_PROGRAM='{1}' {2} -B {3}",
                             sourceFolder().string(), programPath(), python, arguments));
}

TEST(Python, PackageEqualsTheProgram) {
  const std::string python = pythonWith("numpy, pandas, OpenImageIO");
  if (python.empty()) GTEST_SKIP() << "no Python with NumPy, pandas and OpenImageIO (python3-pandas)";
  Outcome outcome = runPython(python, "-W error::ResourceWarning tests/python/test_strobe.py");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// The notebook's cells run and print the text that the notebook stores.
TEST(Python, NotebookIsUpToDate) {
  const std::string python = pythonWith("pandas, OpenImageIO, matplotlib, nbconvert, ipykernel");
  if (python.empty()) GTEST_SKIP() << "no Python with pandas, Matplotlib and nbconvert (jupyter-nbconvert)";
  Outcome outcome = runPython(python, "tests/python/notebook.py docs/python.ipynb");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << "\nnew outputs: PYTHONPATH=$PWD/python " << python
                                  << " tests/python/notebook.py --write docs/python.ipynb";
}

}  // namespace python_test
}  // namespace strobe::testing
