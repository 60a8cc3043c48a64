package org.evoloop.benchmarks.loading;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.evoloop.benchmarks.report.ResidentMemory;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.xmi.ModelFile;

/** Reads a pair of models from a file and compiles its decisions. */
public final class ReadPair {
    private ReadPair() {}

    /**
     * Prints the process's peak resident memory in MB.
     *
     * @param arguments the file; it contains "original" and "new"
     */
    public static void main(String[] arguments) throws IOException {
        DecisionTable table = compile(Path.of(arguments[0]));
        if (table.configurations().isEmpty()) {
            throw new IllegalStateException("nothing was compiled");
        }
        System.out.println("rss " + ResidentMemory.ofThisProcess());
    }

    static DecisionTable compile(Path path) {
        ModelFile file = ModelFile.read(path);
        return compile(new ModelPair(file.pick("original"), file.pick("new")));
    }

    static DecisionTable compile(Path original, Path evolved) {
        return compile(new ModelPair(
                ModelFile.read(original).only(), ModelFile.read(evolved).only()));
    }

    private static DecisionTable compile(ModelPair pair) {
        Set<Event> sendable = new HashSet<>(pair.original().events());
        Event own = new Event("endSpot");
        sendable.remove(own);
        return DecisionTable.compile(pair, new DeviceEvents(sendable, Set.of(own)));
    }
}
