# SPDX-License-Identifier: MIT
# ctest reads this file at its start. Each suite of a test program becomes one test "ROOM.SUITE" in one process: the
# tests of a suite share a device and compiled shaders. A suite that takes longer than `share_s` (costs.txt) is divided
# into shards, "ROOM.SUITE (1 of 3)". The longest tests start first. On four cores or fewer, the shards of a suite run
# one after another: in parallel they would compile the same shaders, in sequence the later shard finds compiled
# shaders. Each process writes its results to results/; `./strobe test` counts them (common/report.cpp).
cmake_minimum_required(VERSION 3.25)

# Tests spend most of their time in the shader compiler of a software device. Processes share compiled shaders in the
# build folder. Without optimization passes and with vectors of four, compilation takes a third of the time; pictures
# are the same bit for bit. Other devices ignore these variables.
set(device "GALLIVM_PERF=nopt;LP_NATIVE_VECTOR_WIDTH=128")

set(share_s 60)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/costs.txt" costs REGEX "^[^#]")

# Processor seconds of each shard of a suite, and the number of shards.
function(cost_of test tests cost shards)
  set(seconds 1)
  foreach(line IN LISTS costs)
    if(line MATCHES "^([0-9]+) (.*)$" AND CMAKE_MATCH_2 STREQUAL test)
      set(seconds ${CMAKE_MATCH_1})
    endif()
  endforeach()
  math(EXPR count "(${seconds} + ${share_s} - 1) / ${share_s}")
  if(count GREATER tests)
    set(count ${tests})
  endif()
  math(EXPR each "${seconds} / ${count}")
  set(${cost} ${each} PARENT_SCOPE)
  set(${shards} ${count} PARENT_SCOPE)
endfunction()

function(add_suite room suite tests program strobe folder)
  cost_of("${room}.${suite}" ${tests} cost shards)
  foreach(shard RANGE 1 ${shards})
    set(name "${room}.${suite}")
    if(shards GREATER 1)
      string(APPEND name " (${shard} of ${shards})")
    endif()
    math(EXPR index "${shard} - 1")
    string(MAKE_C_IDENTIFIER "${name}" file)
    add_test("${name}" "${program}" "--gtest_filter=${suite}.*")
    set_tests_properties("${name}" PROPERTIES TIMEOUT 1200 COST ${cost} ENVIRONMENT
      "${device};MESA_SHADER_CACHE_DIR=${folder}/compiled;STROBE_CACHE=${folder}/cache;STROBE_PROGRAM=${strobe};STROBE_NODE_MODULES=${folder}/node_modules;STROBE_TEST_RESULTS=${folder}/results/${file}.txt;GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
    if(shards GREATER 1 AND cores LESS_EQUAL 4)
      set_tests_properties("${name}" PROPERTIES RESOURCE_LOCK "${room}.${suite}")
    endif()
  endforeach()
endfunction()

# Adds the suites of a program, in the order of its list.
function(add_suites room program strobe folder)
  execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE text RESULT_VARIABLE code TIMEOUT 60)
  if(NOT code EQUAL 0)
    add_test("${room}.not_built" "${program}")
    return()
  endif()
  string(REGEX REPLACE "[^\n]*gtest_main.cc\n" "" text "${text}")
  string(REGEX REPLACE "#[^\n]*" "" text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(suite "")
  foreach(line IN LISTS lines ITEMS "end.")
    if(line MATCHES "^ ")
      math(EXPR tests "${tests} + 1")
      continue()
    endif()
    if(suite)
      add_suite(${room} "${suite}" ${tests} "${program}" "${strobe}" "${folder}")
    endif()
    string(REGEX REPLACE "\\. *$" "" suite "${line}")
    set(tests 0)
  endforeach()
endfunction()
