package org.evoloop.converter.changing;

import org.evoloop.converter.Evolution;
import org.evoloop.converter.Shadow;
import org.evoloop.converter.ShadowReport;
import org.evoloop.converter.running.ConverterShell;

/** The shadow of a running converter. */
final class LiveShadow implements Shadow {
    private final Evolver evolver;
    private final ConverterShell shell;
    private final Evolution evolution;

    LiveShadow(Evolver evolver, ConverterShell shell, Evolution evolution) {
        this.evolver = evolver;
        this.shell = shell;
        this.evolution = evolution;
    }

    @Override
    public Evolution evolution() {
        return evolution;
    }

    @Override
    public ShadowReport report() {
        ShadowReport report = evolver.shadow() == this ? shell.driver().shadowReport() : null;
        if (report == null) {
            throw new IllegalStateException("the shadow has ended");
        }
        return report;
    }

    @Override
    public Evolution.Result promote() {
        return evolver.promote(this, shell);
    }

    @Override
    public void close() {
        evolver.end(this, shell);
    }
}
