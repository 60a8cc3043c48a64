package org.evoloop.config;

/** The parser's message for a file that is not valid YAML, and how to fix it. */
final class Syntax {
    private Syntax() {}

    static String message(String problem) {
        return "this is not YAML: " + problem + "; " + remedy(problem);
    }

    private static String remedy(String problem) {
        if (problem.contains("TAB") || problem.contains("\\t")) {
            return "use spaces instead of tabs";
        }
        if (problem.contains("mapping values are not allowed")) {
            return "begin each option at the start of its line, and quote a value that contains a colon and a space";
        }
        if (problem.contains("could not find expected ':'")) {
            return "write a colon and a space after the option's name";
        }
        if (problem.contains("that cannot start any token")) {
            return "put the value in quotes";
        }
        return "check quotes, brackets and indentation here and in the line before";
    }
}
