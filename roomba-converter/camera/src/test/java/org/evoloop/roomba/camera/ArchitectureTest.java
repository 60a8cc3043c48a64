package org.evoloop.roomba.camera;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** The camera's packages; its module-info says which other modules it may use, of the core only some packages. */
@AnalyzeClasses(packages = "org.evoloop.roomba.camera", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    private static final String OPENCV = "org.evoloop.roomba.camera.opencv..";

    @ArchTest
    static final ArchRule nothingOfARobotIsKnown = noClasses()
            .should()
            .dependOnClassesThat(resideInAPackage("org.evoloop..")
                    .and(resideOutsideOfPackages(
                            "org.evoloop.roomba.camera..", "org.evoloop.natives..", "org.evoloop.time..")));

    @ArchTest
    static final ArchRule onlyOneRoomTouchesOpenCv = noClasses()
            .that()
            .resideOutsideOfPackage(OPENCV)
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.opencv..", OPENCV);

    @ArchTest
    static final ArchRule aCameraIsKnownWithoutHowItWorks = noClasses()
            .that()
            .resideInAPackage("org.evoloop.roomba.camera")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.evoloop.roomba.camera.*..");

    @ArchTest
    static final ArchRule openCvIsAskedWithoutThreads = noClasses()
            .that()
            .resideInAnyPackage("org.evoloop.roomba.camera.vision..", OPENCV)
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.evoloop.roomba.camera.live..", "org.evoloop.roomba.camera.tool..");
}
