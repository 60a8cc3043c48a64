package org.evoloop.device.file;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;

/**
 * A mistake that keeps a text from being YAML. A parser notices it only when it cannot continue, which is often one line
 * late.
 *
 * @param line where the mistake is, from 1
 */
record Malformed(int line, String mistake) {
    private static final Pattern HAS_VALUE = Pattern.compile("\\s*(?:- +)?[^\\s#].*?: +[^\\s#].*");
    private static final Pattern QUOTED = Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"|'[^']*'");

    /** What the parser says about {@code text}. */
    static Malformed of(MarkedYamlEngineException parser, String text) {
        List<String> lines = text.lines().toList();
        int noticed = line(parser.getProblemMark().or(parser::getContextMark));
        String problem = Optional.ofNullable(parser.getProblem()).orElse("this is not YAML");
        int before = lastBefore(noticed, lines);
        if (before > 0 && noticed <= lines.size() && isBelowAValue(lines.get(before - 1), lines.get(noticed - 1))) {
            return new Malformed(
                    before, "it has a value, and line " + noticed + " is indented below it; keep one of them");
        }
        int open = lastOpen(before, lines);
        return open > 0
                ? new Malformed(open, "a bracket is not closed: " + problem + " in line " + noticed)
                : new Malformed(noticed, problem + "; " + remedy(problem));
    }

    private static String remedy(String problem) {
        if (problem.contains("expected <block end>")) {
            return "what belongs to one section begins in the same column: correct the indentation here or in the line before";
        }
        if (problem.contains("mapping values are not allowed")) {
            return "quote a value that contains a colon and a blank, or put several of them into {}";
        }
        return "check quotes, brackets and indentation here and in the line before";
    }

    private static int line(Optional<Mark> mark) {
        return mark.map(Mark::getLine).orElse(0) + 1;
    }

    /** The last line before another that says something; 0 if there is none. */
    private static int lastBefore(int line, List<String> lines) {
        int before = Math.min(line, lines.size() + 1) - 1;
        while (before > 0 && lines.get(before - 1).matches("\\s*(#.*)?")) {
            before--;
        }
        return before;
    }

    /** The last of the lines up to {@code from} whose brackets are not closed up to there; 0 if all are. */
    private static int lastOpen(int from, List<String> lines) {
        int open = 0;
        for (int line = from; line > 0; line--) {
            open += openBrackets(lines.get(line - 1));
            if (open > 0) {
                return line;
            }
        }
        return 0;
    }

    private static boolean isBelowAValue(String above, String below) {
        return indent(below) > indent(above)
                && openBrackets(above) == 0
                && HAS_VALUE.matcher(above).matches();
    }

    private static int indent(String line) {
        return line.length() - line.stripLeading().length();
    }

    private static int openBrackets(String line) {
        String plain = QUOTED.matcher(line).replaceAll("").replaceFirst("(^|\\s)#.*", "");
        int open = 0;
        for (int each : plain.chars().toArray()) {
            open += each == '{' || each == '[' ? 1 : each == '}' || each == ']' ? -1 : 0;
        }
        return open;
    }
}
