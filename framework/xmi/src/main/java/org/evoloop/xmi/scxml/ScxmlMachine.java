package org.evoloop.xmi.scxml;

import java.nio.file.Path;
import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.Problems;

/** The state machine of an SCXML document. */
record ScxmlMachine(ScxmlDocument document) implements DrawnMachine {

    @Override
    public String id() {
        return "";
    }

    /** The name given by the root, or else the file's name without its extension. */
    @Override
    public String name() {
        String name = document.attribute("name").strip();
        if (!name.isEmpty()) {
            return name;
        }
        String file = Path.of(document.file()).getFileName().toString();
        int dot = file.lastIndexOf('.');
        return dot > 0 ? file.substring(0, dot) : file;
    }

    @Override
    public int line() {
        return document.line();
    }

    @Override
    public Statechart statechart(String title, Problems problems) {
        ScxmlLosses.check(document, problems);
        ScxmlDocument read = ScxmlConditions.read(document, problems);
        read = ScxmlRaises.read(read, problems);
        read = ScxmlTimers.read(read, problems);
        return new ScxmlChartReader(new ScxmlTree(read, problems), problems).read(title);
    }
}
