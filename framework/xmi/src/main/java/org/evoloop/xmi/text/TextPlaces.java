package org.evoloop.xmi.text;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.text.Statement.Kind;

/** The places of a diagram's statements in the lines of its text, as they were read. */
record TextPlaces(TextBlock block, Lines lines, List<Statement> statements) {
    static final String INDENT = "    ";

    /** The last line of a region, or the one that begins it. */
    int lastIn(Scope scope) {
        return statements.stream()
                .filter(each ->
                        scope.encloses(each.scope()) && !(each.kind() == Kind.SEPARATOR && each.scope() == scope))
                .mapToInt(Statement::line)
                .max()
                .orElse(scope.place().line());
    }

    /** Inserts a line behind another one, as far indented as the lines of its region. */
    int insert(int behind, Scope scope, String content) {
        String indent = statements.stream()
                .filter(each -> each.scope() == scope && each.kind() != Kind.SEPARATOR)
                .findFirst()
                .map(first -> lines.indent(first.line()))
                .orElseGet(() -> (scope.owner() == null && block.syntax() == Syntax.PLANTUML
                        ? ""
                        : lines.indent(scope.place().line()) + INDENT));
        lines.insert(behind + 1, indent + content);
        return behind + 1;
    }

    /** The last line of a statement, with the contents of the state that it opens. */
    int end(Statement statement) {
        if (statement.kind() != Kind.OPENING) {
            return statement.line();
        }
        int depth = 0;
        for (Statement each : statements.subList(statements.indexOf(statement), statements.size())) {
            depth += each.kind() == Kind.OPENING ? 1 : each.kind() == Kind.CLOSING ? -1 : 0;
            if (depth == 0) {
                return each.line();
            }
        }
        return statement.line();
    }

    /** The only statement of a line. */
    Statement only(int line, Predicate<Statement> wanted) {
        List<Statement> there =
                statements.stream().filter(each -> each.line() == line).toList();
        if (there.size() != 1 || !wanted.test(there.get(0))) {
            throw new ModelException("line " + line + (there.size() > 1 ? " says several things" : " is no transition")
                    + "; edit it in the text");
        }
        return there.get(0);
    }

    /** The lines of what is ignored and begins in a line: only a note without a colon has several. */
    List<Integer> ignored(int first) {
        int last = first;
        String begin = lines.get(first).strip();
        if (begin.startsWith("note ") && begin.indexOf(':') < 0) {
            while (!lines.get(last).strip().matches("end ?note")) {
                last++;
            }
        }
        return IntStream.rangeClosed(first, last).boxed().toList();
    }

    /** The lines of notes and styles, which may name states. */
    List<Integer> ignored() {
        Set<Integer> known = new HashSet<>();
        statements.forEach(each -> known.add(each.line()));
        return Stream.iterate(block.line() + 1, line -> line + 1)
                .limit(block.lines().size())
                .filter(line -> !known.contains(line))
                .filter(line -> lines.get(line).strip().matches("(?:note|class|style|click)\\s.*"))
                .toList();
    }
}
