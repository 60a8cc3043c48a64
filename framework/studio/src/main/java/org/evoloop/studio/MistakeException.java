package org.evoloop.studio;

import java.util.List;

/** A text is no model. */
public final class MistakeException extends RuntimeException {
    private final transient List<Mistake> all;

    /** @param all at least one */
    MistakeException(List<Mistake> all) {
        super(all.get(0).path() + ", line " + all.get(0).line() + ": "
                + all.get(0).message());
        this.all = List.copyOf(all);
    }

    /** What is wrong with it first. */
    public Mistake mistake() {
        return all.get(0);
    }

    /** All that is wrong with it. */
    public List<Mistake> all() {
        return all;
    }
}
