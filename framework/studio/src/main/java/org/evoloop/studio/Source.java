package org.evoloop.studio;

import java.util.function.Supplier;
import org.evoloop.statemachine.ModelException;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.XmiMachine;

/**
 * A machine of a file, which may not be saved yet.
 *
 * <p>Threading: for the thread of the request.
 */
public final class Source {
    private final String path;
    private final String name;
    private final Supplier<ModelFile> file;

    Source(String path, String name, Supplier<ModelFile> file) {
        this.path = path;
        this.name = name;
        this.file = file;
    }

    /** The path of its file in the folder. */
    public String path() {
        return path;
    }

    /** The name by which it was asked for; empty for the only machine. */
    public String name() {
        return name;
    }

    /** The machine, unchecked. */
    public XmiMachine machine() {
        return read(() -> name.isEmpty() ? file.get().findOnly() : file.get().find(name));
    }

    /**
     * What {@code reading} reads of this file.
     *
     * @throws MistakeException with what it reports
     */
    public <T> T read(Supplier<T> reading) {
        try {
            return reading.get();
        } catch (ModelException reported) {
            throw new MistakeException(Mistake.all(path, reported));
        }
    }
}
