package org.evoloop.xmi.astah;

import java.util.Optional;
import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.Problems;

/** A state machine of an Astah file, uninterpreted. */
final class AstahMachine implements DrawnMachine {
    private final AstahUnmarshaller.Result result;
    private final AstahFile file;

    /** @param file complete once the file has been read to its end */
    AstahMachine(AstahUnmarshaller.Result result, AstahFile file) {
        this.result = result;
        this.file = file;
    }

    @Override
    public String id() {
        return result.machine().id();
    }

    @Override
    public String name() {
        return result.machine().name();
    }

    @Override
    public Optional<String> diagramName() {
        return Optional.ofNullable(file.diagramNames().get(id()));
    }

    @Override
    public int line() {
        return result.machine().line;
    }

    @Override
    public Statechart statechart(String title, Problems problems) {
        return new AstahChart(file, problems).read(title, result);
    }
}
