# Runs the commands OURS and THEIRS, which have to print the same.
execute_process(COMMAND ${OURS} OUTPUT_VARIABLE ours COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${THEIRS} OUTPUT_VARIABLE theirs COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n" lines "${ours}")
list(LENGTH lines num_lines)
if(num_lines LESS 19 OR NOT ours STREQUAL theirs)
  message(FATAL_ERROR "here:\n${ours}\nthere:\n${theirs}")
endif()
