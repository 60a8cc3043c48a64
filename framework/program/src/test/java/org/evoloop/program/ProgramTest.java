package org.evoloop.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.page.Picture;
import org.evoloop.xmi.ModelReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Whole programs, with the console that a user types at. */
@Timeout(60)
class ProgramTest {
    private static final String MODELS = """
            ```mermaid
            ---
            title: original
            ---
            stateDiagram-v2
                [*] --> off
                off --> on : switch
                on --> off : switch
            ```

            ```mermaid
            ---
            title: new
            ---
            stateDiagram-v2
                [*] --> off
                off --> on : switch
                on --> warm : switch
                warm --> off : switch
            ```
            """;

    private final InputStream in = System.in;
    private final PrintStream out = System.out;
    private final PrintStream err = System.err;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final ByteArrayOutputStream errors = new ByteArrayOutputStream();
    private final List<String> happened = new ArrayList<>();

    @TempDir
    private Path folder;

    private Path models;

    @BeforeEach
    void redirect() throws IOException {
        models = Files.writeString(folder.resolve("lamp.md"), MODELS);
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        System.setErr(new PrintStream(errors, true, StandardCharsets.UTF_8));
    }

    @AfterEach
    void restore() {
        System.setIn(in);
        System.setOut(out);
        System.setErr(err);
    }

    private EventExecute sending(String... events) {
        return new EventExecute("Lamp") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of(events);
            }

            @Override
            protected void send(Step step) {
                happened.add("sent " + step.trigger());
            }
        };
    }

    private StateKnowledge knowledge(ModelPair pair) {
        return new StateKnowledge(pair) {
            @Override
            protected void registerNewFunctions() {
                function("warm", visit -> happened.add("warm"));
            }
        };
    }

    private Program lamp() {
        return Program.named("lamp", "A lamp.")
                .models(models.toString(), ProgramTest.class)
                .converter(this::assemble);
    }

    private void assemble(ProgramSetup setup) {
        PushMonitor controller = new PushMonitor("Switch");
        setup.converter().addMonitor(controller);
        setup.converter().addExecute(sending("switch"));
        setup.knowledge(this::knowledge);
        setup.command("switch", "operates it", (words, results) -> controller.press("switch"));
        setup.onOpen(() -> happened.add("opened"));
        setup.closing(() -> happened.add("closed"));
    }

    private int run(Program program, String typed, String... options) {
        System.setIn(new ByteArrayInputStream(typed.getBytes(StandardCharsets.UTF_8)));
        return program.run(options);
    }

    private String printed() {
        return printed.toString(StandardCharsets.UTF_8);
    }

    private String errors() {
        return errors.toString(StandardCharsets.UTF_8);
    }

    @Test
    void theModelThatExplainsWhatTheDeviceDoesIsWritten() {
        Path explained = folder.resolve("explained.mmd");
        Flickering bulb = new Flickering();
        Program program = Program.named("lamp", "A lamp.")
                .models(models.toString(), ProgramTest.class)
                .converter(setup -> {
                    assemble(setup);
                    setup.converter().addMonitor(bulb);
                    setup.command("flicker", "switches itself on", (words, results) -> bulb.flicker(setup.converter()));
                });

        assertThat(run(program, "start\ndrift\nflicker\ndrift " + explained + "\ndrift lamp.png\nexit\n"))
                .isZero();

        assertThat(printed())
                .contains("all of the last 0 acts of the device are in its model")
                .contains("   1  off --flicker--> on")
                .contains("written: " + explained);
        assertThat(ModelReference.parse(explained + "#original").load().transitions())
                .extracting(Object::toString)
                .contains("off --flicker--> on", "off --switch--> on");
        assertThat(errors()).contains("error: 'lamp.png' has no ending that names a format");
    }

    private static final class Flickering extends PushMonitor {
        Flickering() {
            super("Bulb");
        }

        void flicker(SystemEventConverter converter) {
            push(fromDevice("flicker"));
            push(foundIn("on"));
            while (!converter.status().drift().toString().contains("--> on")) {
                Thread.onSpinWait();
            }
        }
    }

    @Test
    void itIsOpenedConvertsAndIsClosed() {
        // A command of the program waits for its turn in the loop; stop ends it.
        assertThat(run(lamp(), "start\nswitch\nexit\n")).isZero();

        assertThat(happened).first().isEqualTo("opened");
        assertThat(happened).last().isEqualTo("closed");
        assertThat(printed()).contains("running: original off, new off");
        assertThat(errors()).isEmpty();
    }

    @Test
    void aControllersEventsAreTypedWithTheirBlanksAndOthersAreRefused() {
        Program pressed = lamp().converter(setup -> {
            setup.controller(new PushMonitor("Remote"));
            setup.converter().addExecute(sending("switch"));
            setup.knowledge(this::knowledge);
        });
        assertThat(run(pressed, "start\npress switch\npress dim\nexit\n")).isZero();

        assertThat(errors()).isEqualTo("error: there is no 'dim' here; there is switch\n");
    }

    @Test
    void theModelsOfAnOptionWinAndAllMachinesOfTheirFileAreOffered() throws IOException {
        Path other = Files.writeString(
                folder.resolve("other.md"),
                MODELS.replace(
                        "[*] --> off\n    off --> on : switch\n    on --> warm",
                        "[*] --> off\n    off --> on : switch\n    on --> warm"));
        assertThat(run(lamp(), "evolve nonsense\nexit\n", "--models", other.toString()))
                .isZero();

        assertThat(errors()).startsWith("error: ").contains("nonsense");
    }

    @Test
    void itsJournalIsContinued() {
        String journal = folder.resolve("journal").toString();
        assertThat(run(lamp(), "start\nexit\n", "--journal", journal)).isZero();
        assertThat(run(lamp(), "history\nexit\n", "--journal", journal)).isZero();
        assertThat(run(lamp(), "", "--journal", journal, "--print-config")).isZero();

        assertThat(errors()).isEmpty();
        assertThat(run(lamp(), "", "--journal", models.toString())).isEqualTo(2);
        assertThat(errors()).startsWith("error: the journal " + models);
    }

    @Test
    void helpNamesItsOwnOptionsBesideThoseThatEveryProgramHas() {
        Option<String> colour = Option.value("colour", "NAME", "The lamp's colour.", text -> text);
        assertThat(run(lamp().options(Options.of(colour)), "", "--help")).isZero();

        assertThat(printed())
                .contains(
                        "A lamp.",
                        "--models=FILE",
                        "--colour=NAME",
                        "--journal=DIR",
                        "--page=[HOST:]PORT",
                        "--mqtt=URL");
        assertThat(happened).isEmpty();
    }

    @Test
    void allMistakesAreReportedBeforeAnythingIsOpened() {
        assertThat(run(lamp(), "start\n", "--models", "none.md", "--page", "99999", "--quite"))
                .isEqualTo(2);

        assertThat(errors())
                .startsWith("error: the options have 3 mistakes:")
                .contains(
                        "--models is none.md, which does not exist",
                        "--page takes a port",
                        "there is no option --quite");
        assertThat(happened).isEmpty();
    }

    @Test
    void printingTheOptionsAssemblesItButOpensNothing() {
        assertThat(run(lamp(), "", "--print-config")).isZero();
        assertThat(printed()).startsWith("program: lamp");
        assertThat(happened).containsExactly("closed");

        Program unfit = lamp().converter(setup -> {
            setup.converter().addExecute(sending("swap"));
            setup.knowledge(this::knowledge);
        });
        assertThat(run(unfit, "", "--print-config")).isEqualTo(2);
        assertThat(errors()).startsWith("error: ").contains("swap");
    }

    @Test
    void whatCannotBeAssembledOrOpenedIsOneMessageAndTheRestIsClosed() {
        Program lacking = lamp().converter(setup -> {
            throw new IOException("this computer has no pins; use a Raspberry Pi");
        });
        assertThat(run(lacking, "")).isEqualTo(2);
        assertThat(run(lacking, "", "--print-config")).isEqualTo(2);

        Program unplugged = lamp().converter(setup -> {
            assemble(setup);
            setup.closing(() -> {
                happened.add("closed first");
                throw new IOException("it cannot be closed");
            });
            setup.onOpen(() -> {
                throw new IOException("no cable; plug it in");
            });
        });
        assertThat(run(unplugged, "")).isEqualTo(2);

        assertThat(errors().lines())
                .containsExactly(
                        "error: this computer has no pins; use a Raspberry Pi",
                        "error: this computer has no pins; use a Raspberry Pi",
                        "error: no cable; plug it in");
        assertThat(happened).containsExactly("opened", "closed first", "closed");
    }

    @Test
    void anInterruptWhileItIsOpenedEndsIt() {
        Program interrupted = lamp().converter(setup -> {
            throw new InterruptedException();
        });
        assertThat(run(interrupted, "")).isEqualTo(1);
        assertThat(Thread.interrupted()).isTrue();
        assertThat(run(interrupted, "", "--print-config")).isZero();
        assertThat(Thread.interrupted()).isTrue();
    }

    /** A page with metrics, pictures and limits of the program's own, and a broker that does not answer. */
    @Test
    void whatIsAskedForIsThere() throws Exception {
        Program shown = lamp().loop(usual -> usual.withQueueCapacity(3)).converter("Bulb", setup -> {
            assemble(setup);
            setup.picture(new Picture("Lamp", "The lamp", "image/svg+xml", () -> Picture.View.of(new byte[0])));
            setup.home(home -> happened.add("shown at home"));
            setup.command("look", "reads the page", (words, results) -> results.print(metrics()));
        });
        int status = run(shown, "look\nstatus --all\nexit\n", "--page", "0", "--mqtt", "mqtt://127.0.0.1:1");

        assertThat(status).isZero();
        assertThat(printed()).contains("evoloop_", "Bulb").containsPattern("queue.* 3\\b");
        assertThat(happened).contains("shown at home");
    }

    private String metrics() throws Exception {
        Matcher page = Pattern.compile("page: (http://\\S+/) ").matcher(errors());
        assertThat(page.find()).isTrue();
        return HttpClient.newHttpClient()
                .send(
                        HttpRequest.newBuilder(URI.create(page.group(1) + "metrics"))
                                .build(),
                        HttpResponse.BodyHandlers.ofString())
                .body();
    }

    @Test
    void aConverterThatIsBuiltElsewhereIsRunAsItIs() {
        Program given = Program.named("given", "A lamp.").converter(setup -> {
            SystemEventConverter built =
                    setup.closing(new SystemEventConverter(LoopConfig.defaults("elsewhere", setup.clock())));
            built.addMonitor(new PushMonitor("Switch"));
            built.addExecute(sending("switch"));
            built.addKnowledge(knowledge(ProgramModels.in(models).pair()));
            built.build();
            setup.uses(built);
        });
        assertThat(run(given, "status\nevolve x\nexit\n")).isZero();

        assertThat(printed()).contains("elsewhere");
        assertThat(errors()).contains("evolve");
    }

    @Test
    void aProgramWithoutModelsSaysSo() {
        Program none = Program.named("none", "Nothing.").converter(setup -> setup.knowledge(this::knowledge));
        assertThat(org.assertj.core.api.Assertions.catchThrowable(() -> run(none, "")))
                .hasMessage("the program has no models; call Program.models");
    }
}
