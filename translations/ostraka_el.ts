<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="el" sourcelanguage="en">
<context>
    <name>ostraka::ui::ProjectSession</name>
    <message>
      <source>This project is read-only: you can look at everything, but change nothing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο μπορεί μόνο να διαβαστεί: δείτε τα πάντα· οι αλλαγές δεν γίνονται δεκτές.</translation>
    </message>
    <message>
      <source>The project's folder is not there any more: it was moved, renamed, or its disk was taken out. Open the project again where it is now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος του έργου δεν υπάρχει πια: μετακινήθηκε, μετονομάστηκε ή αφαιρέθηκε ο δίσκος του. Ανοίξτε το έργο εκεί όπου βρίσκεται τώρα.</translation>
    </message>
</context>
<context>
    <name>SideLabels</name>
    <message>
      <source>A label among the fronts names %1, one among the backs %2: check that both sides show the same sherds, and type the bag that they are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια ετικέτα στις μπροστινές όψεις αναφέρει %1 και μια στις πίσω %2: ελέγξτε ότι οι δύο όψεις δείχνουν τα ίδια όστρακα και πληκτρολογήστε τη σακούλα τους.</translation>
    </message>
    <message>
      <source>Labels of several bags are in the photographs: %1. Type the one that these sherds are from.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στις φωτογραφίες υπάρχουν ετικέτες από πολλές σακούλες: %1. Πληκτρολογήστε εκείνη από την οποία είναι αυτά τα όστρακα.</translation>
    </message>
    <message>
      <source>The label in the photographs names %1: check the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ετικέτα στις φωτογραφίες αναφέρει %1: ελέγξτε τη σακούλα.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportAsk</name>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κοιτάξτε πρώτα αυτό</translation>
    </message>
    <message>
      <source>The label in the photographs names %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ετικέτα στις φωτογραφίες αναφέρει %1.</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή</translation>
    </message>
    <message>
      <source>Cancel import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς εισαγωγή</translation>
    </message>
    <message>
      <source>From %1. The bag can also be given later, in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από %1. Η σακούλα μπορεί να δηλωθεί και αργότερα, στον κατάλογο.</translation>
    </message>
    <message>
        <source>Enter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Enter</translation>
    </message>
    <message>
      <source>To import, confirm or move the division between front and back, or choose one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για την εισαγωγή, επιβεβαιώστε ή μετακινήστε τη διαίρεση μεταξύ μπροστινής και πίσω όψης ή επιλέξτε μόνο μία όψη.</translation>
    </message>
</context>
<context>
    <name>Fields</name>
    <message>
      <source>number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αριθμός</translation>
    </message>
    <message>
      <source>identifier</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ταυτότητα</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατάσταση</translation>
    </message>
    <message>
      <source>site</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θέση</translation>
    </message>
    <message>
      <source>trench</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τομή</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο</translation>
    </message>
    <message>
      <source>bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σακούλα</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέρος</translation>
    </message>
    <message>
      <source>ware</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κεραμική κατηγορία</translation>
    </message>
    <message>
      <source>fabric</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πηλός</translation>
    </message>
    <message>
      <source>inclusions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προσμίξεις</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατασκευή</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπτηση</translation>
    </message>
    <message>
      <source>surface outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εξωτερική επιφάνεια</translation>
    </message>
    <message>
      <source>surface inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εσωτερική επιφάνεια</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διακόσμηση</translation>
    </message>
    <message>
      <source>Munsell outside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell έξω</translation>
    </message>
    <message>
      <source>Munsell inside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell μέσα</translation>
    </message>
    <message>
      <source>Munsell core</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Munsell πυρήνας</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διατήρηση</translation>
    </message>
    <message>
      <source>joins with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>συνανήκει με</translation>
    </message>
    <message>
      <source>vessel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αγγείο</translation>
    </message>
    <message>
      <source>period</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περίοδος</translation>
    </message>
    <message>
      <source>date</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χρονολόγηση</translation>
    </message>
    <message>
      <source>length, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μήκος, mm</translation>
    </message>
    <message>
      <source>width, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλάτος, mm</translation>
    </message>
    <message>
      <source>thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάχος, mm</translation>
    </message>
    <message>
      <source>area, mm²</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εμβαδόν, mm²</translation>
    </message>
    <message>
      <source>volume, mm³</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όγκος, mm³</translation>
    </message>
    <message>
      <source>rim diameter, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διάμετρος χείλους, mm</translation>
    </message>
    <message>
      <source>rim kept, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σωζόμενο χείλος, %</translation>
    </message>
    <message>
      <source>weight, g</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>βάρος, g</translation>
    </message>
    <message>
      <source>batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>παρτίδα</translation>
    </message>
    <message>
      <source>note</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σημείωση</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κλίμακα</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
    <message>
      <source>minimum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάχος ελάχιστο, mm</translation>
    </message>
    <message>
      <source>maximum thickness, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάχος μέγιστο, mm</translation>
    </message>
    <message>
      <source>unseen surface, %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αθέατο, %</translation>
    </message>
    <message>
      <source>place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τόπος</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μοντέλο</translation>
    </message>
    <message>
      <source>labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ετικέτες</translation>
    </message>
    <message>
      <source>person</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άτομο</translation>
    </message>
    <message>
      <source>name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όνομα</translation>
    </message>
    <message>
      <source>initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχικά</translation>
    </message>
    <message>
      <source>code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κωδικός</translation>
    </message>
    <message>
      <source>location</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τοποθεσία</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>είδος</translation>
    </message>
    <message>
      <source>excavated on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ανασκάφηκε στις</translation>
    </message>
    <message>
      <source>closed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κλειστό</translation>
    </message>
    <message>
      <source>collected on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>συλλέχθηκε στις</translation>
    </message>
    <message>
      <source>storage</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φύλαξη</translation>
    </message>
    <message>
      <source>operator</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χειριστής</translation>
    </message>
    <message>
      <source>counted sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μετρημένα όστρακα</translation>
    </message>
    <message>
      <source>results</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αποτελέσματα</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πρόγραμμα</translation>
    </message>
    <message>
      <source>project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έργο</translation>
    </message>
    <message>
      <source>title</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τίτλος</translation>
    </message>
    <message>
      <source>institution</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ίδρυμα</translation>
    </message>
    <message>
      <source>licence</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άδεια</translation>
    </message>
    <message>
      <source>rights holder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάτοχος δικαιωμάτων</translation>
    </message>
    <message>
      <source>numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρίθμηση</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φωτογραφία</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σάρωση</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχείο</translation>
    </message>
    <message>
      <source>term</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όρος</translation>
    </message>
    <message>
      <source>content</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περιεχόμενο</translation>
    </message>
    <message>
      <source>mask strokes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πινελιές σε μάσκες</translation>
    </message>
    <message>
      <source>entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>καταχώριση</translation>
    </message>
    <message>
      <source>excavated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ανασκαφή</translation>
    </message>
    <message>
      <source>measured by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μετρημένα με το χέρι</translation>
    </message>
    <message>
      <source>centre of mass x, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κέντρο μάζας x, mm</translation>
    </message>
    <message>
      <source>centre of mass y, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κέντρο μάζας y, mm</translation>
    </message>
    <message>
      <source>centre of mass z, mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κέντρο μάζας z, mm</translation>
    </message>
    <message>
      <source>model file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχείο μοντέλου</translation>
    </message>
    <message>
      <source>picture file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχείο εικόνας</translation>
    </message>
    <message>
      <source>drawing file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχείο σχεδίου</translation>
    </message>
    <message>
      <source>sherds written on the bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακα κατά τη σακούλα</translation>
    </message>
    <message>
      <source>column of the CSV</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στήλη του CSV</translation>
    </message>
    <message>
      <source>column</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στήλη</translation>
    </message>
    <message>
      <source>unit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μονάδα</translation>
    </message>
    <message>
      <source>meaning</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σημασία</translation>
    </message>
    <message>
      <source>reason for voiding</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λόγος ακύρωσης</translation>
    </message>
    <message>
      <source>identical with</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ταυτίζεται με</translation>
    </message>
</context>
<context>
    <name>Job</name>
    <message>
      <source>This is a defect of the program; please report it with the log (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι σφάλμα του προγράμματος· αναφέρετέ το μαζί με το ημερολόγιο (%1).</translation>
    </message>
    <message>
      <source>Not enough memory. Close other programs and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μνήμη δεν φτάνει· κλείστε άλλα προγράμματα και δοκιμάστε ξανά.</translation>
    </message>
</context>
<context>
    <name>PlaceText</name>
    <message>
      <source>%1 bag %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 σακούλα %2</translation>
    </message>
    <message>
      <source>A site, a context and a bag are needed so that the sherds can be numbered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρειάζονται θέση, πλαίσιο και σακούλα για να αριθμηθούν τα όστρακα.</translation>
    </message>
    <message>
      <source>site %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θέση %1</translation>
    </message>
    <message>
      <source>trench %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τομή %1</translation>
    </message>
    <message>
      <source>context %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο %1</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σακούλα %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sherd(s) counted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>μετρήθηκε %n όστρακο</numerusform>
            <numerusform>μετρήθηκαν %n όστρακα</numerusform>
        </translation>
    </message>
    <message>
      <source>invented by the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επινοημένη από την εικονική διάταξη</translation>
    </message>
    <message>
      <source>context %1, although %2 exists</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο %1, αν και υπάρχει το %2</translation>
    </message>
</context>
<context>
    <name>Rig</name>
    <message>
      <source>its file is missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λείπει το αρχείο της</translation>
    </message>
    <message>
      <source>ready (calibrated today)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έτοιμη (βαθμονομήθηκε σήμερα)</translation>
    </message>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>έτοιμη (%n ημέρας)</numerusform>
        <numerusform>έτοιμη (%n ημερών)</numerusform>
      </translation>
    </message>
    <message>
      <source>virtual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εικονική</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
      <source>Finding the cameras</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εντοπισμός των καμερών</translation>
    </message>
    <message>
      <source>Measuring the shape, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέτρηση του σχήματος, εμπρός</translation>
    </message>
    <message>
      <source>Measuring the shape, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέτρηση του σχήματος, πίσω</translation>
    </message>
    <message>
      <source>Cutting the sherds out, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποκοπή κάθε οστράκου, εμπρός</translation>
    </message>
    <message>
      <source>Cutting the sherds out, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποκοπή κάθε οστράκου, πίσω</translation>
    </message>
    <message>
      <source>Matching fronts and backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ταίριασμα μπροστινών και πίσω όψεων</translation>
    </message>
    <message>
      <source>Closing the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλείσιμο των μοντέλων</translation>
    </message>
    <message>
      <source>Writing the report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύνταξη της αναφοράς</translation>
    </message>
    <message>
      <source>Entering the sherds into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καταχώριση των οστράκων στον κατάλογο</translation>
    </message>
    <message>
      <source>Starting</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έναρξη</translation>
    </message>
    <message>
      <source>Looking for other partners in doubtful pairs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναζήτηση άλλων ταιριών για τα αμφίβολα ζεύγη</translation>
    </message>
    <message>
      <source>Finding the sherds, front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εντοπισμός οστράκων, εμπρός</translation>
    </message>
    <message>
      <source>Finding the sherds, back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εντοπισμός οστράκων, πίσω</translation>
    </message>
</context>
<context>
    <name>Time</name>
    <message>
      <source>less than a minute left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λιγότερο από ένα λεπτό ακόμη</translation>
    </message>
    <message>
      <source>about %1 min left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περίπου %1 λεπτά ακόμη</translation>
    </message>
    <message>
      <source>about %1 h left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περίπου %1 ώρες ακόμη</translation>
    </message>
</context>
<context>
    <name>ostraka::ui</name>
    <message>
      <source>numbered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αριθμημένο</translation>
    </message>
    <message>
      <source>void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άκυρο</translation>
    </message>
    <message>
      <source>on a scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>με ζυγαριά</translation>
    </message>
    <message>
      <source>with a calliper</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>με παχύμετρο</translation>
    </message>
    <message>
      <source>by the program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>από το πρόγραμμα</translation>
    </message>
    <message>
      <source>aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στην άκρη</translation>
    </message>
    <message>
      <source>%1 or %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ή %2</translation>
    </message>
    <message>
      <source>The photograph is not there any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία δεν υπάρχει πια.</translation>
    </message>
    <message>
      <source>The printer or file cannot be written; choose another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν γίνεται εγγραφή στον εκτυπωτή ή στο αρχείο· επιλέξτε άλλο.</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
    <message>
      <source>The printer took no further page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο εκτυπωτής δεν δέχτηκε άλλη σελίδα.</translation>
    </message>
    <message>
      <source>The printer or file could not be finished; is the disk full?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εκτύπωση ή το αρχείο δεν ολοκληρώθηκε· μήπως γέμισε ο δίσκος;</translation>
    </message>
    <message>
      <source>%1 and %2 both fit %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 και το %2 ταιριάζουν και τα δύο στο %3.</translation>
    </message>
    <message>
      <source>Its back was given to another front: is %1 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του δόθηκε σε άλλη μπροστινή: είναι τώρα το %1 το σωστό;</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>under 1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάτω από 1 %</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
      <source>The back lies upside down: both sides face the same way.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη είναι ανάποδα: και οι δύο όψεις κοιτούν προς την ίδια πλευρά.</translation>
    </message>
    <message>
      <source>The faces cross: %1 of the front lies behind the back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι όψεις διασταυρώνονται: το %1 της μπροστινής βρίσκεται πίσω από την πίσω όψη.</translation>
    </message>
    <message>
      <source>shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέα λήψη</translation>
    </message>
    <message>
      <source>%1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 – %2</translation>
    </message>
    <message>
      <source>No back was found for it. Choose one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε πίσω όψη. Επιλέξτε μία, ή βάλτε το στην άκρη.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποφασίστηκε από %1 στις %2.</translation>
    </message>
    <message>
      <source>Set aside by %1 on %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπήκε στην άκρη από %1 στις %2.</translation>
    </message>
    <message>
      <source>bag %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σακούλα %1</translation>
    </message>
    <message>
      <source>This back is set aside. Drag it onto a front to use it after all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η πίσω όψη είναι στην άκρη. Σύρετέ τη σε μια μπροστινή για να χρησιμοποιηθεί τελικά.</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message numerus="yes">
      <source>%1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1 από %n όστρακο</numerusform>
        <numerusform>%1 από %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αμφίβολη</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2: is %3 the right one now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του %1 δόθηκε στο %2: είναι τώρα το %3 το σωστό;</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2. Choose another one, or set it aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του %1 δόθηκε στο %2. Επιλέξτε άλλη, ή βάλτε το στην άκρη.</translation>
    </message>
    <message>
      <source>Its back %1 was given to %2; next best %3, %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη του %1 δόθηκε στο %2· επόμενη καλύτερη %3, %4.</translation>
    </message>
    <message>
      <source>Decided by %1 on %2, turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποφασίστηκε από %1 στις %2, στράφηκε με το χέρι.</translation>
    </message>
    <message>
      <source>by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>με το χέρι</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχικό σημείο</translation>
    </message>
    <message>
      <source>Turned by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στράφηκε με το χέρι.</translation>
    </message>
    <message>
      <source>%1 decided for %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το άτομο %1 αποφάσισε για το %2.</translation>
    </message>
    <message>
      <source>The program says %1, %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα λέει %1, %2.</translation>
    </message>
    <message>
      <source>Sure by what was decided for others: %1; by itself %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βέβαιο από όσα αποφασίστηκαν για άλλα: %1· από μόνο του %2.</translation>
    </message>
    <message>
      <source>%1, aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, στην άκρη</translation>
    </message>
    <message>
      <source>%1, shoot again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, νέα λήψη</translation>
    </message>
    <message>
      <source>%1, void</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, άκυρο</translation>
    </message>
    <message>
      <source>%1 in %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 στην %2</translation>
    </message>
    <message>
      <source>now %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τώρα %1</translation>
    </message>
    <message>
        <source>front %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>μπροστινή όψη %1</translation>
    </message>
    <message>
        <source>back %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>πίσω όψη %1</translation>
    </message>
    <message>
        <source>Merged with %1 by %2. It is one fragment once the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συγχωνεύτηκε με %1 από %2. Θα είναι ένα θραύσμα μετά την επανεπεξεργασία της παρτίδας.</translation>
    </message>
    <message>
        <source>Split by %1. Its fragments appear when the batch is reprocessed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διαιρέθηκε από %1. Τα θραύσματα εμφανίζονται μετά την επανεπεξεργασία της παρτίδας.</translation>
    </message>
    <message>
        <source>Merged</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συγχωνευμένο</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διαιρεμένο</translation>
    </message>
    <message>
        <source>No front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Χωρίς μπροστινή όψη</translation>
    </message>
    <message>
        <source>This back is to be reshot.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αυτή η πίσω όψη πρέπει να φωτογραφηθεί ξανά.</translation>
    </message>
    <message>
        <source>No front holds this back. Drag it onto its front, merge it with another, or set it aside.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Καμία μπροστινή όψη δεν έχει αυτή την πίσω όψη. Σύρετέ τη στη μπροστινή της, συγχωνεύστε τη με άλλη ή αφήστε τη στην άκρη.</translation>
    </message>
    <message>
        <source>%1 and %2 both fit %3: their fractures differ by only %4.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 και %2 ταιριάζουν με %3: οι θραύσεις διαφέρουν μόνο κατά %4.</translation>
    </message>
    <message>
        <source>%1 would fit %2 almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 θα ταίριαζε σχεδόν εξίσου καλά με %2.</translation>
    </message>
    <message>
        <source>%1 fits barely better than an unrelated back.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 ταιριάζει ελάχιστα καλύτερα από μια άσχετη πίσω όψη.</translation>
    </message>
    <message>
        <source>Ambiguous: a second position fits almost as well.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αμφίσημο: μια δεύτερη θέση ταιριάζει σχεδόν εξίσου καλά.</translation>
    </message>
    <message>
        <source>%1 confident</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Βεβαιότητα %1</translation>
    </message>
    <message>
        <source>Check</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>No back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Χωρίς πίσω όψη</translation>
    </message>
    <message>
        <source>Sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Βέβαιο</translation>
    </message>
    <message>
        <source>Decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αποφασίστηκε</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Στην άκρη</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Νέα λήψη</translation>
    </message>
    <message>
        <source>To be reshot, decided by %1 on %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Για νέα λήψη, απόφαση %1, %2.</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αντικατάσταση με τη μετρημένη τιμή</translation>
    </message>
    <message>
        <source>Delete computed value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διαγραφή της υπολογισμένης τιμής</translation>
    </message>
    <message>
        <source>Save this value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αποθήκευση αυτής της τιμής</translation>
    </message>
    <message>
        <source>%1 (computed %2)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 (υπολογισμένο %2)</translation>
    </message>
    <message>
        <source>The two scans share only %1 of the fracture.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Οι δύο σαρώσεις έχουν κοινό μόνο το %1 της θραύσης.</translation>
    </message>
    <message>
      <source>no number yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς αριθμό ακόμη</translation>
    </message>
    <message>
      <source>Another partner fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο ταίρι ταιριάζει σχεδόν εξίσου καλά.</translation>
    </message>
    <message>
      <source>no probability</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χωρίς πιθανότητα</translation>
    </message>
    <message>
      <source>The nearest outline; no probability is known.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πλησιέστερο περίγραμμα· δεν είναι γνωστή καμία πιθανότητα.</translation>
    </message>
    <message>
      <source>Another front takes the same back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια άλλη μπροστινή όψη παίρνει την ίδια πίσω όψη.</translation>
    </message>
    <message>
      <source>The two scans share almost no fracture; only their outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δύο σαρώσεις δεν έχουν σχεδόν καμία κοινή θραύση· μόνο τα περιγράμματα τις συνδέουν.</translation>
    </message>
    <message>
      <source>The fractures do not fit: %1 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι θραύσεις δεν ταιριάζουν: απόσταση %1.</translation>
    </message>
    <message>
      <source>The fracture barely fixes the position: uncertain by %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η θραύση μόλις που ορίζει τη θέση: αβεβαιότητα %1.</translation>
    </message>
    <message>
      <source>A position %1 along the contour fits almost as well.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια θέση %1 πιο πέρα στο περίγραμμα ταιριάζει σχεδόν εξίσου καλά.</translation>
    </message>
    <message>
      <source>The fractures cannot be compared; only the outlines match.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι θραύσεις δεν συγκρίνονται· μόνο τα περιγράμματα συνδέουν αυτές τις όψεις.</translation>
    </message>
    <message>
      <source>refined</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ρυθμισμένο</translation>
    </message>
    <message>
      <source>Turned by hand: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στράφηκε με το χέρι: ακουμπά το %1 των θραύσεων.</translation>
    </message>
    <message>
      <source>Trying another start point: %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται άλλο αρχικό σημείο: ακουμπά το %1 των θραύσεων.</translation>
    </message>
    <message>
      <source>Trying another start point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται άλλο αρχικό σημείο.</translation>
    </message>
    <message>
      <source>Refined by the fractures: %1 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίστηκε από τις θραύσεις: ακουμπά το %1.</translation>
    </message>
    <message>
      <source>Refined by the fractures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίστηκε από τις θραύσεις.</translation>
    </message>
    <message>
      <source>Trying %1: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται το %1: %2.</translation>
    </message>
    <message>
      <source>Trying %1: %2, fractures %3 apart.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται το %1: %2, θραύσεις σε απόσταση %3.</translation>
    </message>
    <message>
      <source>Trying %1: %2; its fractures do not touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμάζεται το %1: %2· οι θραύσεις δεν ακουμπούν.</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο %1 της %2</translation>
    </message>
    <message>
      <source>imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εισαγμένο</translation>
    </message>
    <message>
      <source>estimated by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εκτιμημένο με το χέρι</translation>
    </message>
    <message>
      <source>%1 confident; below %2, a person decides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βεβαιότητα %1· κάτω από %2 αποφασίζει άνθρωπος.</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Enter</translation>
    </message>
    <message>
      <source>%1 ± %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ± %2</translation>
    </message>
    <message>
      <source>Only %1 of the fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακουμπά μόνο το %1 των θραύσεων.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep a number of the old context: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο κρατά αριθμό του παλιού πλαισίου: %1.</numerusform>
        <numerusform>%n όστρακα κρατούν αριθμό του παλιού πλαισίου: %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag, because there is no bag %1 yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο αφήνει τη σακούλα του, γιατί δεν υπάρχει ακόμη σακούλα %1.</numerusform>
        <numerusform>%n όστρακα αφήνουν τις σακούλες τους, γιατί δεν υπάρχει ακόμη σακούλα %1.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) leave their bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο αφήνει τη σακούλα του.</numerusform>
        <numerusform>%n όστρακα αφήνουν τις σακούλες τους.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BatchImporter</name>
    <message>
      <source>Import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή του %1</translation>
    </message>
    <message>
      <source>The copy cannot be put in its place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αντίγραφο δεν μπορεί να μπει στη θέση του: %1.</translation>
    </message>
    <message numerus="yes">
      <source>Sheet recognised: %n marker(s). Sizes follow from the marker side that was typed, %1 mm; check it on the paper with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Το φύλλο αναγνωρίστηκε: %n δείκτης. Τα μεγέθη βασίζονται στην πλευρά δείκτη που δόθηκε, %1 mm· ελέγξτε την στο χαρτί με χάρακα.</numerusform>
        <numerusform>Το φύλλο αναγνωρίστηκε: %n δείκτες. Τα μεγέθη βασίζονται στην πλευρά δείκτη που δόθηκε, %1 mm· ελέγξτε την στο χαρτί με χάρακα.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο, βέβαιο</numerusform>
        <numerusform>%n όστρακα, όλα βέβαια</numerusform>
      </translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Warning: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προσοχή: %1</translation>
    </message>
    <message>
      <source>again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ξανά</translation>
    </message>
    <message>
      <source>%1: paused</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: σε παύση</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1; but %n counted on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1· αλλά %n μετρήθηκε στον δίσκο</numerusform>
        <numerusform>%1· αλλά %n μετρήθηκαν στον δίσκο</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 waits for the draft of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 περιμένει το προσχέδιο του %2.</translation>
    </message>
    <message>
      <source>This batch's cameras were found anew; calibrate the rig again (C).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για αυτή την παρτίδα οι κάμερες βρέθηκαν εκ νέου· βαθμονομήστε ξανά τη διάταξη (C).</translation>
    </message>
    <message>
      <source>You set it aside. Its photographs are kept; R takes it up again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Την παραμερίσατε. Οι φωτογραφίες της μένουν· το R την παίρνει πάλι.</translation>
    </message>
    <message>
      <source>%1; is %2 the sherd that it was? It measured %3 mm, now %4 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1· είναι το %2 το ίδιο όστρακο; Μετρούσε %3 mm, τώρα %4 mm</translation>
    </message>
    <message>
      <source>%1; the number %2 was typed on its plate, and none of its sherds has it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1· ο αριθμός %2 πληκτρολογήθηκε στην πλάκα της, και κανένα όστρακό της δεν τον έχει</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n photographed again since</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%1· %n φωτογραφήθηκε ξανά από τότε</numerusform>
            <numerusform>%1· %n φωτογραφήθηκαν ξανά από τότε</numerusform>
        </translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Στην άκρη</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Λήψη</translation>
    </message>
    <message>
        <source>Queued</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Σε αναμονή</translation>
    </message>
    <message>
        <source>Processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Σε επεξεργασία</translation>
    </message>
    <message>
        <source>Paused</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Σε παύση</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>Needs review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Θέλει έλεγχο</translation>
    </message>
    <message>
        <source>Done</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Έτοιμο</translation>
    </message>
    <message>
        <source>Draft: review it, then reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Προσχέδιο: ελέγξτε το και επανεπεξεργαστείτε την παρτίδα</translation>
    </message>
    <message>
        <source>Masks edited: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Οι μάσκες άλλαξαν: επανεπεξεργασία</translation>
    </message>
    <message>
        <source>Scale in doubt: see the report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αμφίβολη κλίμακα: δείτε την αναφορά</translation>
    </message>
    <message>
        <source>Decided: reprocess it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αποφασίστηκε: επανεπεξεργασία</translation>
    </message>
    <message>
        <source>%1 sure</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 βέβαια</translation>
    </message>
    <message>
        <source>%1 decided</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 αποφασισμένα</translation>
    </message>
    <message>
        <source>%1 to review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 για έλεγχο</translation>
    </message>
    <message>
        <source>draft, to be reprocessed; %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>προσχέδιο, για επανεπεξεργασία· %1</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n to reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%1· %n για νέα λήψη</numerusform>
            <numerusform>%1· %n για νέα λήψη</numerusform>
        </translation>
    </message>
    <message>
      <source>%1; joined to within %2 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1· ένωση με σφάλμα έως %2 mm</translation>
    </message>
    <message numerus="yes">
      <source>%1 is ready: %n sherd(s).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Η %1 είναι έτοιμη: %n όστρακο.</numerusform>
        <numerusform>Η %1 είναι έτοιμη: %n όστρακα.</numerusform>
      </translation>
    </message>
    <message>
      <source>You cancelled it. Finished stages are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Την ακυρώσατε. Τα ολοκληρωμένα στάδια είναι αποθηκευμένα.</translation>
    </message>
    <message>
      <source>You removed it from the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τη βγάλατε από την ουρά.</translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) queued.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Σε παύση· περιμένει %n παρτίδα.</numerusform>
        <numerusform>Σε παύση· περιμένουν %n παρτίδες.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 was bumped: it misses the markers by %2 px, %3 mm from where it was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 μετακινήθηκε: χάνει τους δείκτες κατά %2 px, %3 mm από εκεί όπου βαθμονομήθηκε.</translation>
    </message>
    <message>
      <source>It was interrupted. Reprocess it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακόπηκε· επανεπεξεργαστείτε την.</translation>
    </message>
    <message>
      <source>No bag was given; its sherds get their context in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε σακούλα· τα όστρακά της παίρνουν το πλαίσιό τους στον κατάλογο.</translation>
    </message>
    <message>
        <source>%1: stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: διακόπτεται…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διακόπτεται…</translation>
    </message>
    <message>
      <source>%1, %2 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Draft: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Προσχέδιο: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BigButton</name>
    <message>
      <source>Key: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλήκτρο: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::BulkEdit</name>
    <message>
      <source>Field to change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πεδίο που αλλάζει</translation>
    </message>
    <message>
      <source>New value for all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα τιμή για όλα</translation>
    </message>
    <message>
      <source>new value; empty deletes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέα τιμή· το κενό διαγράφει</translation>
    </message>
    <message>
      <source>sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο</translation>
    </message>
    <message>
      <source>now</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τώρα</translation>
    </message>
    <message>
      <source>then</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μετά</translation>
    </message>
    <message>
      <source>What would change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι θα άλλαζε</translation>
    </message>
    <message>
      <source>Change</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αλλαγή</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πεδίο</translation>
    </message>
    <message>
      <source>Value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τιμή</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο επιλέχθηκε</numerusform>
        <numerusform>%n όστρακα επιλέχθηκαν</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Change %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Αλλαγή %n οστράκου</numerusform>
        <numerusform>Αλλαγή %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Progress of the changes</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος των αλλαγών</translation>
    </message>
    <message>
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Απόδοση αριθμών</translation>
    </message>
    <message>
        <source>Replace with measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αντικατάσταση με τη μετρημένη τιμή</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n τιμή χρειάζεται επιβεβαίωση.</numerusform>
            <numerusform>%n τιμές χρειάζονται επιβεβαίωση.</numerusform>
        </translation>
    </message>
    <message>
      <source>rejected: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>απορρίφθηκε: %1</translation>
    </message>
    <message>
      <source>Cancel and undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακύρωση και αναίρεση</translation>
    </message>
    <message>
      <source>To change: %1. Unchanged: %2. Rejected: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προς αλλαγή: %1. Αμετάβλητα: %2. Απορρίπτονται: %3.</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση</translation>
    </message>
    <message>
      <source>Type a value to see what would change, or press Enter in the empty field to delete.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πληκτρολογήστε μια τιμή για να δείτε τι θα άλλαζε ή πατήστε Enter στο κενό πεδίο για διαγραφή.</translation>
    </message>
    <message>
      <source>Make these bags</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δημιουργία σακουλών</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CandidateBar</name>
    <message>
      <source>%1, with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, τώρα με το %2</translation>
    </message>
    <message>
      <source>%1   %2   %3
%4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1   %2   %3
%4</translation>
    </message>
    <message>
      <source>Candidate %1: %2, %3, %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υποψήφιο %1: %2, %3, %4</translation>
    </message>
    <message>
      <source>%1, nobody's</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, ελεύθερο</translation>
    </message>
    <message>
        <source>gap %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>κενό %1</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>χωρίς επαφή</translation>
    </message>
    <message>
      <source>Another back…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλη πίσω όψη …</translation>
    </message>
    <message>
      <source>by outline alone</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μόνο από το περίγραμμα</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureFoot</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάστημα</translation>
    </message>
    <message>
      <source>Typed, from a code reader, or from the bag's label laid under the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Με πληκτρολόγηση, από αναγνώστη κωδικών, ή από την ετικέτα της σακούλας κάτω από την κάμερα</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureScreen</name>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάστημα</translation>
    </message>
    <message>
      <source>%1 is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 είναι στην ουρά.</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: εισήχθη %n αρχείο· είναι στην ουρά.</numerusform>
        <numerusform>%1: εισήχθησαν %n αρχεία· είναι στην ουρά.</numerusform>
      </translation>
    </message>
    <message>
      <source>Photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση ξανά</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή φωτογραφιών…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή σαρώσεων…</translation>
    </message>
    <message>
      <source>Camera %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1</translation>
    </message>
    <message>
      <source>Capture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λήψη</translation>
    </message>
    <message>
      <source>R</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>R</translation>
    </message>
    <message>
      <source>does not answer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν απαντά</translation>
    </message>
    <message>
      <source>%1 The desktop holds a camera, by its program %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Η επιφάνεια εργασίας κρατά μια κάμερα, με το πρόγραμμά της %2.</translation>
    </message>
    <message>
      <source>Type the sherds' numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πληκτρολόγηση των αριθμών των οστράκων</translation>
    </message>
    <message>
      <source>This project photographs with no calibrated rig of its own.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο δεν φωτογραφίζει με δική του βαθμονομημένη διάταξη.</translation>
    </message>
    <message>
      <source>The rig is calibrated by %1; the calibration before is kept as %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη βαθμονομήθηκε από το %1· η προηγούμενη φυλάσσεται ως %2.</translation>
    </message>
    <message>
      <source>'%1' names no bag: write site-trench-context-bag, or empty the line to go on without one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» δεν ονομάζει σακούλα: γράψτε θέση-τομή-πλαίσιο-σακούλα ή αδειάστε τη γραμμή για να συνεχίσετε χωρίς.</translation>
    </message>
    <message>
      <source>Set this batch aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παραμερισμός αυτής της παρτίδας</translation>
    </message>
    <message>
      <source>The bag is another now, the numbers are not</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σακούλα είναι τώρα άλλη, οι αριθμοί όχι</translation>
    </message>
    <message>
      <source>Not as this bag&apos;s sherds are numbered: %1. Type them anew (N, or later in the catalogue), or say that they are right.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όχι όπως αριθμούνται τα όστρακα αυτής της σακούλας: %1. Πληκτρολογήστε τους ξανά (N, ή αργότερα στον κατάλογο), ή πείτε ότι είναι σωστοί.</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>OK</translation>
    </message>
    <message>
        <source>Next step</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επόμενο βήμα</translation>
    </message>
    <message>
      <source>Stop turntable</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στάση τραπεζιού</translation>
    </message>
    <message>
      <source>Change rig…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλη διάταξη…</translation>
    </message>
    <message>
      <source>Loading picture…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα έρχεται.</translation>
    </message>
    <message>
      <source>Check this first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κοιτάξτε πρώτα αυτό</translation>
    </message>
    <message>
      <source>Type how many sherds lie there</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δήλωση του αριθμού των οστράκων</translation>
    </message>
    <message>
      <source>Import cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εισαγωγή ακυρώθηκε· δεν έμεινε τίποτα.</translation>
    </message>
    <message>
      <source>Import anyway</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή παρ’ όλα αυτά</translation>
    </message>
    <message>
      <source>Photograph this side again?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Να φωτογραφηθεί ξανά αυτή η όψη;</translation>
    </message>
    <message>
      <source>Keep these numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι σωστοί</translation>
    </message>
    <message>
        <source>%1 The rig that worked before stays in use.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 Η προηγούμενη διάταξη παραμένει σε χρήση.</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διατήρηση των φωτογραφιών</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, %2 %</translation>
    </message>
    <message>
      <source>%1 already has these files, so nothing was imported. If you import them anyway, its sherds appear twice in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 έχει ήδη αυτά τα αρχεία, γι’ αυτό δεν εισήχθη τίποτα. Αν τα εισαγάγετε παρ’ όλα αυτά, τα όστρακά του εμφανίζονται δύο φορές στον κατάλογο.</translation>
    </message>
    <message>
      <source>%1 already has %2 of these %3 files, so nothing was imported. If you import them anyway, the catalogue holds the sherds of both batches; if you do not want that, set %1 aside in the queue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 έχει ήδη %2 από αυτά τα %3 αρχεία, γι’ αυτό δεν εισήχθη τίποτα. Αν τα εισαγάγετε παρ’ όλα αυτά, ο κατάλογος περιέχει τα όστρακα και των δύο· αν δεν το θέλετε, βάλτε το %1 στην άκρη στην ουρά.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CaptureWizard</name>
    <message>
      <source>The label beside the backs names %1, but the fronts are of %2: check that these are the same sherds, or correct the bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ετικέτα δίπλα στις πίσω όψεις αναφέρει %1, ενώ οι μπροστινές είναι από %2: ελέγξτε ότι είναι τα ίδια όστρακα ή διορθώστε τη σακούλα.</translation>
    </message>
    <message>
      <source>Opening the rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα της διάταξης</translation>
    </message>
    <message>
      <source>Press the shutter of camera %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πατήστε το κλείστρο της κάμερας %1.</translation>
    </message>
    <message>
      <source>%1 %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %2</translation>
    </message>
    <message>
      <source>No rig yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει ακόμη διάταξη</translation>
    </message>
    <message>
      <source>Lay the sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τοποθετήστε τα όστρακα στον δίσκο</translation>
    </message>
    <message>
      <source>Stopped</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σταμάτησε</translation>
    </message>
    <message>
      <source>Photographing the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση μπροστινών όψεων</translation>
    </message>
    <message>
      <source>Turn each sherd over where it lies</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γυρίστε κάθε όστρακο στη θέση του</translation>
    </message>
    <message>
      <source>Photographing the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση πίσω όψεων</translation>
    </message>
    <message>
      <source>You may clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπορείτε να αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>Shifting is fine, swapping is fine, losing one is not.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μετακίνηση και η αλλαγή θέσης επιτρέπονται, η απώλεια όχι.</translation>
    </message>
    <message>
      <source>%1 is in the queue; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 είναι στην ουρά· η επόμενη παρτίδα απέχει ένα πλήκτρο.</translation>
    </message>
    <message>
      <source>Done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έγινε</translation>
    </message>
    <message>
      <source>Try again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμή ξανά</translation>
    </message>
    <message>
      <source>Shoot the fronts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογράφιση μπροστινών όψεων</translation>
    </message>
    <message>
      <source>All turned: shoot the backs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα γύρισαν: φωτογράφιση πίσω όψεων</translation>
    </message>
    <message>
      <source>Next batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενη παρτίδα</translation>
    </message>
    <message>
      <source>One moment</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια στιγμή</translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Μπροστά: %n όστρακο</numerusform>
        <numerusform>Μπροστά: %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>Front: %1 sherds, now %2 are seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστά: %1 όστρακα, τώρα φαίνονται %2</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστά %1, πίσω %2</translation>
    </message>
    <message>
      <source>This camera has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η κάμερα δεν δείχνει ζωντανή εικόνα.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Φαίνεται %n όστρακο</numerusform>
        <numerusform>Φαίνονται %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 may be two sherds, too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 ίσως είναι δύο όστρακα πολύ κοντά</translation>
    </message>
    <message>
      <source>%1 and %2 lie too close together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα %1 και %2 είναι πολύ κοντά</translation>
    </message>
    <message>
      <source>%1 reaches out of the picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 βγαίνει από την εικόνα</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too dark</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 % των οστράκων είναι πολύ σκοτεινό</translation>
    </message>
    <message>
      <source>%1 % of the sherds is too bright</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 % των οστράκων είναι πολύ φωτεινό</translation>
    </message>
    <message>
      <source>Read from the label: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από την ετικέτα: %1</translation>
    </message>
    <message>
      <source>No room for more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν χωρά άλλο</translation>
    </message>
    <message numerus="yes">
      <source>Room for about %n more</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Χωρά περίπου %n ακόμη</numerusform>
        <numerusform>Χωρούν περίπου %n ακόμη</numerusform>
      </translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: look for one that is hidden, touches another or was never laid down.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσατε %1 όστρακα, οι φωτογραφίες δείχνουν %2: ψάξτε ένα που κρύβεται, αγγίζει άλλο ή δεν τοποθετήθηκε.</translation>
    </message>
    <message>
      <source>You counted %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσατε %1</translation>
    </message>
    <message>
      <source>%1 was interrupted in the middle of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 διακόπηκε στη μέση αυτής της όψης.</translation>
    </message>
    <message>
      <source>%1 is photographed whole, but nobody said that it is right: look at its photographs, then go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 φωτογραφήθηκε ολόκληρη, αλλά κανείς δεν είπε ότι είναι σωστή: δείτε τις φωτογραφίες της και συνεχίστε.</translation>
    </message>
    <message>
      <source>To be photographed again: %1. Lay them down with others, and type their numbers (N) when the fronts are shot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για νέα φωτογράφιση: %1. Τοποθετήστε τα με άλλα και γράψτε τους αριθμούς τους (N) αφού φωτογραφηθούν οι μπροστινές όψεις.</translation>
    </message>
    <message>
      <source>Labels of several bags are in sight: %1. Leave the one of these sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φαίνονται ετικέτες περισσότερων σακουλών: %1. Αφήστε μόνο αυτήν των οστράκων εδώ.</translation>
    </message>
    <message>
      <source>You counted %1 sherds, the photographs show %2: check whether one is in fragments or an object is not a sherd, or correct the count.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσατε %1 όστρακα, οι φωτογραφίες δείχνουν %2: δείτε μήπως κάποιο είναι σε κομμάτια ή υπάρχει κάτι που δεν είναι όστρακο, ή διορθώστε τον αριθμό.</translation>
    </message>
    <message>
        <source>The rig does not open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η διάταξη δεν ανοίγει</translation>
    </message>
    <message>
        <source>Taking calibration photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Λήψη φωτογραφιών βαθμονόμησης</translation>
    </message>
    <message>
        <source>The virtual rig turns the sherds over</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η εικονική διάταξη γυρίζει τα όστρακα</translation>
    </message>
    <message>
        <source>Nothing to do by hand: shoot the backs.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Τίποτα με το χέρι: φωτογραφίστε τις πίσω όψεις.</translation>
    </message>
    <message>
        <source>Resume at position %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συνέχεια στη στάση %1</translation>
    </message>
    <message>
        <source>Shoot the backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Λήψη πίσω όψεων</translation>
    </message>
    <message>
        <source>Calibration photograph %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φωτογραφία βαθμονόμησης %1 από %2</translation>
    </message>
    <message>
        <source>Position %1 of %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Στάση %1 από %2</translation>
    </message>
    <message>
        <source>Opening the rig…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Άνοιγμα της διάταξης</translation>
    </message>
    <message>
        <source>Lighting OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φωτισμός OK</translation>
    </message>
    <message>
      <source>%1 resumes where it stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 συνεχίζει από εκεί που ήταν.</translation>
    </message>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Η φωτογραφία αυτής της όψης είναι αποθηκευμένη.</numerusform>
        <numerusform>Οι %n φωτογραφίες αυτής της όψης είναι αποθηκευμένες.</numerusform>
      </translation>
    </message>
    <message>
      <source>Camera %1 at position %2: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1, στάση %2: %3</translation>
    </message>
    <message>
      <source>Check the plate before you clear it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κοιτάξτε τον δίσκο πριν τον αδειάσετε</translation>
    </message>
    <message>
      <source>Fronts up, two centimetres apart, the markers at the edge of the plate free.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστινή όψη επάνω, απόσταση δύο εκατοστών, οι δείκτες στην άκρη του δίσκου ελεύθεροι.</translation>
    </message>
    <message>
      <source>Hands off the turntable. Esc stops it at once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μακριά τα χέρια από το τραπέζι. Το Esc το σταματά αμέσως.</translation>
    </message>
    <message>
      <source>Space accepts anyway, R photographs the backs again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το διάστημα συνεχίζει έτσι κι αλλιώς, το R φωτογραφίζει ξανά τις πίσω όψεις.</translation>
    </message>
    <message>
      <source>Accept and queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποδοχή και στην ουρά</translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) saved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n φωτογραφία είναι ασφαλής</numerusform>
        <numerusform>%n φωτογραφίες είναι ασφαλείς</numerusform>
      </translation>
    </message>
    <message>
      <source>Markers %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δείκτες %1 από %2</translation>
    </message>
    <message>
      <source>Release camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Απελευθέρωση της κάμερας</translation>
    </message>
    <message>
      <source>Markers %1 of %2, %3 needed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δείκτες %1 από %2, χρειάζονται %3</translation>
    </message>
    <message>
      <source>Its sherds are in the review (Ctrl+3): check them while they still lie here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακά της είναι στον έλεγχο (Ctrl+3): δείτε τα όσο είναι ακόμη εδώ</translation>
    </message>
    <message>
        <source>The turntable stands still. Saved photographs are kept.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Το περιστρεφόμενο τραπέζι είναι ακίνητο. Οι αποθηκευμένες φωτογραφίες διατηρούνται.</translation>
    </message>
    <message>
      <source>Nothing is wrong with the photographs of this side. Space or Esc keeps them; R once more puts all of them aside and takes new ones.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες αυτής της όψης δεν έχουν κανένα πρόβλημα. Το Διάστημα ή το Esc τις διατηρεί· ένα ακόμη R τις βάζει όλες στην άκρη και λαμβάνει νέες.</translation>
    </message>
    <message>
      <source>Keep the photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διατήρηση των φωτογραφιών</translation>
    </message>
    <message>
      <source>Stopping…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακόπτεται…</translation>
    </message>
    <message>
      <source>%1 is processed; the next batch is one key away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 έχει υποστεί επεξεργασία· η επόμενη παρτίδα απέχει ένα πλήκτρο.</translation>
    </message>
    <message>
      <source>No photograph of this side has been taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν έχει τραβηχτεί καμία φωτογραφία αυτής της όψης.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueScreen</name>
    <message numerus="yes">
      <source>change %1 of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>αλλαγή: %1, %n όστρακο</numerusform>
        <numerusform>αλλαγή: %1, %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>Catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κατάλογος</translation>
    </message>
    <message>
      <source>Export these</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή αυτών</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά σας</translation>
    </message>
    <message>
      <source>Who is working? Your initials go into the history:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποιος εργάζεται; Τα αρχικά σας μπαίνουν στο ιστορικό:</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα</translation>
    </message>
    <message>
      <source>Search</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναζήτηση</translation>
    </message>
    <message>
      <source>Edit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επεξεργασία</translation>
    </message>
    <message>
      <source>change %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή: %1</translation>
    </message>
    <message>
      <source>move to another context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μεταφορά σε άλλο πλαίσιο</translation>
    </message>
    <message>
      <source>changes by the import of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγές από την εισαγωγή του %1</translation>
    </message>
    <message>
      <source>Imported %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή του %1: %2</translation>
    </message>
    <message>
      <source>Numbers, contexts and descriptions from a table, or an export (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί, πλαίσια και περιγραφές από πίνακα, ή μια εξαγωγή (%1)</translation>
    </message>
    <message>
      <source>About what is chosen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για τα επιλεγμένα</translation>
    </message>
    <message>
      <source>Details</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στοιχεία</translation>
    </message>
    <message>
      <source>Drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχέδιο</translation>
    </message>
    <message>
      <source>Details or drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στοιχεία ή σχέδιο</translation>
    </message>
    <message>
      <source>enter the rim's diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>καταχώριση διαμέτρου χείλους</translation>
    </message>
    <message>
      <source>Import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή</translation>
    </message>
    <message>
      <source>The import of %1 broke off after %2 of %3 rows; these are whole. Import it again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εισαγωγή του %1 διακόπηκε μετά από %2 από %3 γραμμές· αυτές είναι πλήρεις. Εισαγάγετε ξανά για τα υπόλοιπα.</translation>
    </message>
    <message>
      <source>Choose the sherds that are to get numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε τα όστρακα που θα πάρουν αριθμό.</translation>
    </message>
    <message>
        <source>No sherds yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δεν υπάρχουν ακόμη όστρακα</translation>
    </message>
    <message>
        <source>Sherds appear here when a batch is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Τα όστρακα εμφανίζονται εδώ όταν επεξεργαστεί μια παρτίδα.</translation>
    </message>
    <message>
        <source>No sherds match this filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Κανένα όστρακο δεν ταιριάζει στο φίλτρο</translation>
    </message>
    <message>
        <source>Remove a condition to see more.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αφαιρέστε μια συνθήκη για να δείτε περισσότερα.</translation>
    </message>
    <message>
        <source>Clear filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Καθαρισμός φίλτρου</translation>
    </message>
    <message>
        <source>Model</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μοντέλο</translation>
    </message>
    <message>
        <source>Assign numbers</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Απόδοση αριθμών</translation>
    </message>
    <message>
        <source>A void sherd gets no label, drawing or place on a plate, and its number is never given again. Is %1 void: “%2”?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ένα άκυρο όστρακο δεν παίρνει ετικέτα, σχέδιο ή θέση σε δίσκο, και ο αριθμός του δεν ξαναδίνεται. Είναι άκυρο το %1: «%2»;</translation>
    </message>
    <message>
      <source>Import…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή …</translation>
    </message>
    <message>
      <source>Dismiss</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παράβλεψη</translation>
    </message>
    <message>
        <source>Void sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ακύρωση οστράκου</translation>
    </message>
    <message>
      <source>Compare</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it; closing again discards it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν έχει αποθηκευτεί ακόμη: %1. Το Enter στο πεδίο αποθηκεύει· νέο κλείσιμο απορρίπτει.</translation>
    </message>
    <message numerus="yes">
      <source>Export %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Εξαγωγή %n οστράκου</numerusform>
        <numerusform>Εξαγωγή %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Print labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση ετικετών</translation>
    </message>
    <message>
      <source>sherd labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ετικέτες οστράκων</translation>
    </message>
    <message>
      <source>Only sherds with a number get a label: assign the numbers first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ετικέτα παίρνουν μόνο όστρακα με αριθμό: δώστε πρώτα τους αριθμούς.</translation>
    </message>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετονομασία τόπων</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::DrawingPage</name>
    <message>
      <source>Scale of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα του σχεδίου</translation>
    </message>
    <message>
      <source>1 : 1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 1</translation>
    </message>
    <message>
      <source>1 : 2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 2</translation>
    </message>
    <message>
      <source>How surfaces are drawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πώς σχεδιάζονται οι επιφάνειες</translation>
    </message>
    <message>
      <source>Whether it is a rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αν είναι χείλος</translation>
    </message>
    <message>
      <source>Scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα</translation>
    </message>
    <message>
      <source>Surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιφάνεια</translation>
    </message>
    <message>
      <source>Rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χείλος</translation>
    </message>
    <message>
      <source>Enter the diameter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καταχώριση διαμέτρου</translation>
    </message>
    <message>
      <source>Print the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση του σχεδίου</translation>
    </message>
    <message>
      <source>Progress of the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος του σχεδίου</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>What the drawing says</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι λέει το σχέδιο</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε όστρακο.</translation>
    </message>
    <message>
      <source>Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στόμιο %1 cm (95 %: %2 έως %3), σώζεται το %4 % του χείλους.</translation>
    </message>
    <message>
      <source>%1 drawn, %2 left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχεδιάστηκαν %1, παραλείφθηκαν %2.</translation>
    </message>
    <message numerus="yes">
      <source>Draw plates of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Πίνακες %n οστράκου</numerusform>
        <numerusform>Πίνακες %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Sheet %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φύλλο %1 από %2</translation>
    </message>
    <message>
      <source>plates</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίνακες</translation>
    </message>
    <message>
      <source>Save the drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση του σχεδίου</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε: %1</translation>
    </message>
    <message>
      <source>The drawing is sent to the printer; print it at 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το σχέδιο στέλνεται στον εκτυπωτή· τυπώστε το στο 100 %.</translation>
    </message>
    <message>
      <source>Automatic</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτόματα</translation>
    </message>
    <message>
      <source>Rim sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο χείλους</translation>
    </message>
    <message>
      <source>No rim</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς χείλος</translation>
    </message>
    <message>
      <source>Save…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση …</translation>
    </message>
    <message>
      <source>Print…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση …</translation>
    </message>
    <message>
      <source>Previous sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το προηγούμενο φύλλο</translation>
    </message>
    <message>
      <source>Next sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το επόμενο φύλλο</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was drawn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακυρώθηκε. Δεν σχεδιάστηκε τίποτα.</translation>
    </message>
    <message numerus="yes">
      <source>Drawing %n sherd(s)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Σχεδίαση %n οστράκου …</numerusform>
        <numerusform>Σχεδίαση %n οστράκων …</numerusform>
      </translation>
    </message>
    <message>
      <source>PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg);;PNG, the views of each sherd (*.png);;TIFF, the views of each sherd (*.tif)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>PDF, όλα τα φύλλα (*.pdf);;SVG, ένα αρχείο ανά φύλλο (*.svg);;PNG, οι όψεις κάθε οστράκου (*.png);;TIFF, οι όψεις κάθε οστράκου (*.tif)</translation>
    </message>
    <message>
      <source>Different</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διαφορετικά</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportModel</name>
    <message>
      <source>less than a minute</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λιγότερο από ένα λεπτό</translation>
    </message>
    <message numerus="yes">
      <source>about %n minute(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>περίπου %n λεπτό</numerusform>
        <numerusform>περίπου %n λεπτά</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1 files, %2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο, %1 αρχεία, %2, %3</numerusform>
        <numerusform>%n όστρακα, %1 αρχεία, %2, %3</numerusform>
      </translation>
    </message>
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη φάκελος με αυτό το όνομα· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), %1, manifest checked</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο, %1, ο κατάλογος αρχείων ελέγχθηκε</numerusform>
        <numerusform>%n όστρακα, %1, ο κατάλογος αρχείων ελέγχθηκε</numerusform>
      </translation>
    </message>
    <message>
      <source>Counting…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέτρηση …</translation>
    </message>
    <message>
      <source>No sherds match this selection.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα όστρακο δεν ταιριάζει· επιλέξτε άλλα.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was left behind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακυρώθηκε. Δεν έμεινε τίποτα.</translation>
    </message>
    <message numerus="yes">
      <source>%n of them without a model: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n από αυτά χωρίς μοντέλο: %1</numerusform>
        <numerusform>%n από αυτά χωρίς μοντέλο: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>The whole project, %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ολόκληρο το έργο, %1</translation>
    </message>
    <message numerus="yes">
      <source>%n file(s) of the project are missing, changed or links; damage.txt in the archive lists them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n αρχείο του έργου λείπει, έχει αλλάξει ή είναι σύνδεσμος· το damage.txt το αναφέρει.</numerusform>
        <numerusform>%n αρχεία του έργου λείπουν, έχουν αλλάξει ή είναι σύνδεσμοι· το damage.txt τα αναφέρει.</numerusform>
      </translation>
    </message>
    <message>
        <source>Everything in the project, with checksums. &apos;Restore an archive&apos; on the start screen makes the project from it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Όλα όσα έχει το έργο, με αθροίσματα ελέγχου. Η «Επαναφορά αρχείου έργου» στην αρχική οθόνη φτιάχνει πάλι το έργο από αυτό.</translation>
    </message>
    <message numerus="yes">
        <source>%n batch(es) in the queue: the archive holds their photographs and the stages that are finished when it is made; the restored project processes the rest.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n παρτίδα στην ουρά: το αρχείο έργου έχει τις φωτογραφίες της και τα στάδια που θα έχουν τελειώσει ως τότε· το έργο μετά την επαναφορά επεξεργάζεται τα υπόλοιπα.</numerusform>
            <numerusform>%n παρτίδες στην ουρά: το αρχείο έργου έχει τις φωτογραφίες τους και τα στάδια που θα έχουν τελειώσει ως τότε· το έργο μετά την επαναφορά επεξεργάζεται τα υπόλοιπα.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ExportScreen</name>
    <message>
      <source>Exported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή έγινε: %1</translation>
    </message>
    <message>
      <source>Export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή</translation>
    </message>
    <message>
      <source>What</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι</translation>
    </message>
    <message>
      <source>All sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα όστρακα</translation>
    </message>
    <message>
      <source>Filter of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φίλτρο της εξαγωγής</translation>
    </message>
    <message>
      <source>context:0012</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο:0012</translation>
    </message>
    <message>
      <source>A picture of each model (PNG)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια εικόνα κάθε μοντέλου (PNG)</translation>
    </message>
    <message>
      <source>Models as PLY, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλα ως PLY, σε mm</translation>
    </message>
    <message>
      <source>Models as GLB, for the web and for slides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλα ως GLB, για τον ιστό και παρουσιάσεις</translation>
    </message>
    <message>
      <source>Models as OBJ, in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλα ως OBJ, σε mm</translation>
    </message>
    <message>
      <source>The photographs, unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες, αμετάβλητες</translation>
    </message>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού</translation>
    </message>
    <message>
      <source>New folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος φάκελος για την εξαγωγή</translation>
    </message>
    <message>
      <source>Progress of the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της εξαγωγής</translation>
    </message>
    <message>
      <source>Open folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα φακέλου</translation>
    </message>
    <message>
      <source>Drawings for print (SVG and PDF)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχέδια για εκτύπωση (SVG και PDF)</translation>
    </message>
    <message>
      <source>Scale of the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα των σχεδίων</translation>
    </message>
    <message>
      <source>1 : 1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 1</translation>
    </message>
    <message>
      <source>1 : 2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>1 : 2</translation>
    </message>
    <message>
      <source>Pictures, masks, poses for COLMAP and OpenMVS</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνες, μάσκες, θέσεις για COLMAP και OpenMVS</translation>
    </message>
    <message>
      <source>Detail of the models</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λεπτομέρεια των μοντέλων</translation>
    </message>
    <message>
      <source>How large a GLB may be. PLY and OBJ get the same surface. Larger models get fewer triangles and smaller photographs; how far they are off is measured and stated in each file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πόσο μεγάλο μπορεί να είναι ένα GLB. Τα PLY και OBJ έχουν την ίδια επιφάνεια. Τα μεγαλύτερα μοντέλα έχουν λιγότερα τρίγωνα και μικρότερες φωτογραφίες· η απόκλισή τους μετριέται και γράφεται σε κάθε αρχείο.</translation>
    </message>
    <message>
      <source>Stop the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή της εξαγωγής</translation>
    </message>
    <message>
      <source>Export: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξαγωγή: %1</translation>
    </message>
    <message>
      <source>The export is not finished, and nothing of it would be kept. Close once more to stop it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εξαγωγή δεν έχει τελειώσει και δεν θα έμενε τίποτα από αυτήν. Κλείστε ξανά για να διακοπεί.</translation>
    </message>
    <message>
        <source>Matching the filter</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Που ταιριάζουν στο φίλτρο</translation>
    </message>
    <message>
        <source>Formats</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μορφές</translation>
    </message>
    <message>
        <source>Records (JSON), re-importable</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εγγραφές (JSON), επανεισαγώγιμες</translation>
    </message>
    <message>
        <source>Full detail</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Πλήρης λεπτομέρεια</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>Selected sherds</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επιλεγμένα όστρακα</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή …</translation>
    </message>
    <message>
      <source>Folder for the export</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού να είναι ο φάκελος;</translation>
    </message>
    <message>
      <source>fit to A4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπως χωρά σε A4</translation>
    </message>
    <message>
      <source>for the web, up to 5 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>για τον ιστό, έως 5 MB</translation>
    </message>
    <message>
      <source>for a phone, up to 1 MB</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>για τηλέφωνο, έως 1 MB</translation>
    </message>
    <message>
      <source>Tables (CSV): English headings, decimal points</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (CSV): αγγλικές επικεφαλίδες, τελεία</translation>
    </message>
    <message>
      <source>Tables (ODS): LibreOffice, Excel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (ODS): LibreOffice, Excel</translation>
    </message>
    <message>
      <source>The whole project, as an archive</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ολόκληρο το έργο, ως αρχείο φύλαξης</translation>
    </message>
    <message>
      <source>Surfaces in the drawings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιφάνειες στα σχέδια</translation>
    </message>
    <message numerus="yes">
      <source>%n selected sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n επιλεγμένο όστρακο</numerusform>
        <numerusform>%n επιλεγμένα όστρακα</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::FilterLine</name>
    <message>
      <source>Filter of the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φίλτρο του καταλόγου</translation>
    </message>
    <message>
      <source>rim T3 thickness&gt;6</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>rim T3 πάχος&gt;6</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>Remove the condition %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αφαίρεση του όρου %1</translation>
    </message>
    <message>
      <source>Words are looked for everywhere; ware:grey, thickness&gt;6, entered&gt;=2026-07-01, -burnt, note:* also work.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι λέξεις αναζητούνται παντού· ισχύουν και τα ware:grey, πάχος&gt;6, καταχώριση&gt;=2026-07-01, -burnt, σημείωση:*.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::FooterLine</name>
    <message>
      <source>What the computer does</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι κάνει ο υπολογιστής</translation>
    </message>
    <message>
      <source>What was done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι έγινε</translation>
    </message>
    <message>
      <source>Progress of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος του υπολογισμού</translation>
    </message>
    <message>
        <source>Idle</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αδρανές</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::HeaderLine</name>
    <message>
      <source>Where</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού</translation>
    </message>
    <message>
      <source>Rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάταξη</translation>
    </message>
    <message>
      <source>Room on the disk</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χώρος στον δίσκο</translation>
    </message>
    <message>
      <source>Rig: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάταξη: %1</translation>
    </message>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Δίσκος: χώρος για %n παρτίδα</numerusform>
        <numerusform>Δίσκος: χώρος για %n παρτίδες</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::HelpPage</name>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εγχειρίδιο</translation>
    </message>
    <message>
      <source>&amp;Contents</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Περιεχόμενα</translation>
    </message>
    <message>
      <source>All &amp;keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα π&amp;λήκτρα</translation>
    </message>
    <message>
      <source>&amp;About</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Σχετικά</translation>
    </message>
    <message>
      <source>Back to work (Esc)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω στη δουλειά (Esc)</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα πλήκτρα</translation>
    </message>
    <message>
      <source>Complete, measured 3D models of potsherds from photographs of both their sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλήρη, μετρημένα τρισδιάστατα μοντέλα οστράκων από φωτογραφίες και των δύο όψεών τους.</translation>
    </message>
    <message>
      <source>Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file LICENSE and the README name them all.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άδεια Apache 2.0. Χρησιμοποιεί μεταξύ άλλων Qt (LGPL 3), VTK και OpenCV· το αρχείο LICENSE και το README τα αναφέρουν όλα.</translation>
    </message>
    <message>
      <source>The manual is in English.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το εγχειρίδιο υπάρχει μόνο στα αγγλικά.</translation>
    </message>
    <message>
      <source>Nothing leaves this computer: the program uses no network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τίποτα δεν φεύγει από αυτόν τον υπολογιστή: το πρόγραμμα δεν χρησιμοποιεί δίκτυο.</translation>
    </message>
    <message>
      <source>Search the manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναζήτηση στο εγχειρίδιο</translation>
    </message>
    <message>
      <source>The manual does not mention &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το εγχειρίδιο δεν αναφέρει «%1».</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportDialog</name>
    <message>
      <source>new</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>νέο</translation>
    </message>
    <message>
      <source>Import into the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή στον κατάλογο</translation>
    </message>
    <message>
      <source>Make sites, trenches, contexts and bags that are not there yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δημιουργία θέσεων, τομών, πλαισίων και σακουλών που λείπουν</translation>
    </message>
    <message>
      <source>Progress of the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της εισαγωγής</translation>
    </message>
    <message>
      <source>Which table?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποιος πίνακας;</translation>
    </message>
    <message>
      <source>Tables (*.csv *.tsv *.txt);;All (*)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (*.csv *.tsv *.txt);;Όλα (*)</translation>
    </message>
    <message>
      <source>Which export?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποια εξαγωγή;</translation>
    </message>
    <message>
      <source>Tables (*.csv)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίνακες (*.csv)</translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε: %1</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλείσιμο</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>Keep the other versions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κράτηση των άλλων εκδοχών</translation>
    </message>
    <message>
        <source>to confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>προς επιβεβαίωση</translation>
    </message>
    <message>
        <source>Rows</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Γραμμές</translation>
    </message>
    <message>
        <source>Columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Στήλες</translation>
    </message>
    <message numerus="yes">
        <source>Columns (%n to check)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Στήλες (%n προς έλεγχο)</numerusform>
            <numerusform>Στήλες (%n προς έλεγχο)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Confirm %n row(s)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Επιβεβαίωση %n γραμμής</numerusform>
            <numerusform>Επιβεβαίωση %n γραμμών</numerusform>
        </translation>
    </message>
    <message>
      <source>updated</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άλλαξε</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>απορρίφθηκε</translation>
    </message>
    <message>
      <source>unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ως έχει</translation>
    </message>
    <message>
      <source>Table (CSV)…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας πίνακας (CSV) …</translation>
    </message>
    <message>
      <source>Export folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας φάκελος εξαγωγής …</translation>
    </message>
    <message>
      <source>Effect of each row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι θα έκανε κάθε γραμμή</translation>
    </message>
    <message>
      <source>Save rejected rows…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση όσων απορρίφθηκαν …</translation>
    </message>
    <message>
      <source>Save rejected rows</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση όσων απορρίφθηκαν</translation>
    </message>
    <message>
      <source>rejected.csv</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>refused.csv</translation>
    </message>
    <message>
      <source>Line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γραμμή</translation>
    </message>
    <message>
      <source>Action</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τι γίνεται</translation>
    </message>
    <message>
      <source>Reason</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γιατί όχι</translation>
    </message>
    <message>
      <source>Reading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εξέταση …</translation>
    </message>
    <message>
      <source>Imported: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισήχθησαν: %1</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακύρωση</translation>
    </message>
    <message numerus="yes">
      <source>Import %n row(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Εισαγωγή %n γραμμής</numerusform>
        <numerusform>Εισαγωγή %n γραμμών</numerusform>
      </translation>
    </message>
    <message>
      <source>Another project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο έργο …</translation>
    </message>
    <message>
        <source>A table of sherds has a column with their numbers; one of contexts has a column with theirs. Their names may be in any of the program's languages.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ένας πίνακας οστράκων έχει μια στήλη με τους αριθμούς τους· ένας πίνακας πλαισίων έχει μια στήλη με τους δικούς τους. Τα ονόματα μπορούν να είναι σε οποιαδήποτε γλώσσα του προγράμματος.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportModel</name>
    <message>
      <source>%1 '%2': %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 «%2»: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) ask for a confirmation.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>%n γραμμή χρειάζεται επιβεβαίωση.</numerusform>
            <numerusform>%n γραμμές χρειάζονται επιβεβαίωση.</numerusform>
        </translation>
    </message>
    <message>
      <source>%1 new, %2 updated, %3 unchanged, %4 rejected.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 νέα, %2 άλλαξαν, %3 ως έχουν, %4 απορρίφθηκαν.</translation>
    </message>
    <message>
      <source>Cancelled. Nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακυρώθηκε. Δεν εισήχθη τίποτα.</translation>
    </message>
    <message numerus="yes">
      <source>Cancelled: %n row(s) were not imported. Import the table again for the rest.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Σταμάτησε: %n γραμμή δεν καταχωρήθηκε. Εισαγάγετε ξανά τον πίνακα για τα υπόλοιπα.</numerusform>
        <numerusform>Σταμάτησε: %n γραμμές δεν καταχωρήθηκαν. Εισαγάγετε ξανά τον πίνακα για τα υπόλοιπα.</numerusform>
      </translation>
    </message>
    <message>
      <source>Undo does not take back contexts and bags; the catalogue is backed up before the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αναίρεση δεν παίρνει πίσω πλαίσια και σακούλες· πριν από την εισαγωγή γίνεται αντίγραφο ασφαλείας του καταλόγου.</translation>
    </message>
    <message>
      <source>Undo does not take back new sherds; each can be voided in its details.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αναίρεση δεν αφαιρεί τα νέα όστρακα· το καθένα μπορεί να ακυρωθεί στις λεπτομέρειές του.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::JoinMode</name>
    <message>
      <source>Which back belongs to the one of %1? Choose its card (arrows and Enter).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποια πίσω όψη ανήκει σε εκείνη του %1; Επιλέξτε την κάρτα της (βέλη και Enter).</translation>
    </message>
    <message>
      <source>Which front belongs to the one of %1? Choose its card (arrows and Enter); a click on a back's picture joins the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποια μπροστινή όψη ανήκει σε εκείνη του %1; Επιλέξτε την κάρτα της (βέλη και Enter)· ένα κλικ στην εικόνα μιας πίσω όψης συγχωνεύει τις πίσω όψεις.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MainWindow</name>
    <message>
      <source>Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka</translation>
    </message>
    <message>
      <source>%1 stopped: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 σταμάτησε: %2</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναίρεση</translation>
    </message>
    <message>
      <source>Manual</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εγχειρίδιο</translation>
    </message>
    <message>
      <source>All keys</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα πλήκτρα</translation>
    </message>
    <message>
      <source>Other projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλα έργα</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έργα</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίσεις</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βοήθεια</translation>
    </message>
    <message>
      <source>Back to work</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω στη δουλειά</translation>
    </message>
    <message>
      <source>This project is open in another window already: go on there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο είναι ήδη ανοιχτό σε άλλο παράθυρο: συνεχίστε εκεί.</translation>
    </message>
    <message>
      <source>%1 - Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 - Ostraka</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικονική διάταξη</translation>
    </message>
    <message>
      <source>Everywhere</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παντού</translation>
    </message>
    <message>
      <source>The computation is being stopped; it goes on when the project is opened again. The window closes in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο υπολογισμός σταματά· συνεχίζει όταν ανοίξει ξανά το έργο. Το παράθυρο κλείνει σε λίγο.</translation>
    </message>
    <message>
      <source>Undo: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναίρεση: %1</translation>
    </message>
    <message>
      <source>The catalogue could not be copied: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κατάλογος δεν αντιγράφηκε: %1</translation>
    </message>
    <message>
        <source>%1 is ready.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Το %1 είναι έτοιμο.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επανάληψη</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επανάληψη: %1</translation>
    </message>
    <message>
      <source>Queue: editing masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ουρά: επεξεργασία μασκών</translation>
    </message>
    <message>
      <source>%1 (read-only)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (μόνο για ανάγνωση)</translation>
    </message>
    <message>
      <source>%1 is being processed. Leaving the project stops it, and it continues when the project is opened again. Choose Projects once more to leave.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα %1 υποβάλλεται σε επεξεργασία. Η έξοδος από το έργο τη σταματά και συνεχίζεται όταν το έργο ανοίξει ξανά. Επιλέξτε πάλι Έργα για έξοδο.</translation>
    </message>
    <message>
      <source>Import cancelled</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εισαγωγή ακυρώθηκε</translation>
    </message>
    <message>
      <source>The project that was created for it is removed. Your photographs are as they were.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο που δημιουργήθηκε γι’ αυτήν αφαιρέθηκε. Οι φωτογραφίες σας είναι όπως ήταν.</translation>
    </message>
    <message>
        <source>Restoring cancelled</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η επαναφορά ακυρώθηκε</translation>
    </message>
    <message>
        <source>Nothing was left behind.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δεν έμεινε τίποτα.</translation>
    </message>
    <message>
        <source>The project is restored.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η επαναφορά του έργου ολοκληρώθηκε.</translation>
    </message>
    <message>
        <source>It was archived with damage:</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Είχε αρχειοθετηθεί με βλάβες:</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapScreen</name>
    <message>
      <source>Print map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση χάρτη και ετικετών</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1</translation>
    </message>
    <message>
      <source>Batch %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα %1</translation>
    </message>
    <message>
      <source>Batch %1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα %1, %2</translation>
    </message>
    <message>
      <source>Map and labels are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χάρτης και οι ετικέτες στέλνονται στον εκτυπωτή.</translation>
    </message>
    <message>
      <source>Map</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χάρτης</translation>
    </message>
    <message>
      <source>Print bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση ετικετών σακουλών</translation>
    </message>
    <message>
      <source>Print a label for each bag; its code gives a batch its context (Ctrl+Shift+P)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εκτύπωση ετικέτας για κάθε σακούλα· ο κωδικός της δίνει στην παρτίδα το πλαίσιό της (Ctrl+Shift+P)</translation>
    </message>
    <message>
      <source>There is no bag yet: type one at the capture, or import a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει ακόμη σακούλα: πληκτρολογήστε μία στη λήψη ή εισαγάγετε πίνακα πλαισίων.</translation>
    </message>
    <message numerus="yes">
      <source>%n label(s) are sent to the printer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n ετικέτα στάλθηκε στον εκτυπωτή.</numerusform>
        <numerusform>%n ετικέτες στάλθηκαν στον εκτυπωτή.</numerusform>
      </translation>
    </message>
    <message>
      <source>This batch was scanned, not photographed: there is no picture of its plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα σαρώθηκε, δεν φωτογραφήθηκε: δεν υπάρχει εικόνα του δίσκου της.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) of this batch have no number yet: their labels name the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο αυτής της παρτίδας δεν έχει ακόμη αριθμό: η ετικέτα του γράφει την παρτίδα.</numerusform>
        <numerusform>%n όστρακα αυτής της παρτίδας δεν έχουν ακόμη αριθμό: οι ετικέτες τους γράφουν την παρτίδα.</numerusform>
      </translation>
    </message>
    <message>
      <source>Saved: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε: %1</translation>
    </message>
    <message>
        <source>No map yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δεν υπάρχει ακόμη χάρτης</translation>
    </message>
    <message>
      <source>The map is still loading.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χάρτης φορτώνεται ακόμη.</translation>
    </message>
    <message>
        <source>The map of a batch appears here once it is processed, and shows which sherd lay where.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο χάρτης μιας παρτίδας εμφανίζεται εδώ μετά την επεξεργασία της και δείχνει πού ήταν κάθε όστρακο.</translation>
    </message>
    <message>
      <source>%1 map and labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 χάρτης και ετικέτες</translation>
    </message>
    <message>
      <source>bag labels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ετικέτες σάκων</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MapView</name>
    <message>
      <source>Plate, front and back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δίσκος, μπροστά και πίσω</translation>
    </message>
    <message>
      <source>Sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φόρτωση…</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MessagePanel</name>
    <message>
      <source>What happened</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τι συνέβη</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Παράβλεψη</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ModelPane</name>
    <message>
      <source>Picture of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα του οστράκου</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή</translation>
    </message>
    <message>
      <source>Cut the model open; Shift and the wheel move the plane</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή του μοντέλου· το Shift και ο τροχός μετακινούν το επίπεδο</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από πάνω</translation>
    </message>
    <message>
      <source>No model yet: it comes when the batch of the sherd is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει ακόμη μοντέλο: δημιουργείται όταν επεξεργαστεί η παρτίδα του οστράκου.</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the model cannot be turned.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η οθόνη δεν έχει OpenGL 3.2, οπότε το μοντέλο δεν περιστρέφεται.</translation>
    </message>
    <message>
      <source>No model: the sherd belongs to no batch of photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς μοντέλο: το όστρακο δεν ανήκει σε καμία παρτίδα φωτογραφιών.</translation>
    </message>
    <message>
      <source>Large view</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μεγάλη προβολή</translation>
    </message>
    <message>
      <source>The model alone, as large as the page; again or Esc: beside the table</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μόνο το μοντέλο, σε όλη τη σελίδα· ξανά ή Esc: δίπλα στον πίνακα</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NewProject</name>
    <message>
      <source>The site&apos;s code has two to eight letters from A to Z and digits, without accents, like ARM1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός της θέσης έχει δύο έως οκτώ λατινικά κεφαλαία από A έως Z και ψηφία, χωρίς τόνους, όπως ARM1.</translation>
    </message>
    <message>
      <source>Choose a folder for the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε φάκελο για το έργο.</translation>
    </message>
    <message>
      <source>There is a project in this folder already: open it, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη έργο σε αυτόν τον φάκελο: ανοίξτε το, ή επιλέξτε άλλον.</translation>
    </message>
    <message>
      <source>This folder holds other files: choose a new one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος έχει άλλα αρχεία: επιλέξτε νέο.</translation>
    </message>
    <message>
      <source>Virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικονική διάταξη</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φωτογραφίες</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::OutlinePlot</name>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Outlines overlaid, and their turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Περιγράμματα το ένα πάνω στο άλλο, και οι γωνίες στροφής τους</translation>
    </message>
    <message>
      <source>Outlines overlaid</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>περιγράμματα μαζί</translation>
    </message>
    <message>
      <source>Turning angles</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γωνίες στροφής</translation>
    </message>
    <message>
      <source>The lines of a pair lie on each other.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε ένα ζεύγος οι γραμμές συμπίπτουν.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardInHand</name>
    <message>
      <source>No back is chosen.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν επιλέχθηκε πίσω όψη.</translation>
    </message>
    <message>
      <source>choice of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επιλογή του %1</translation>
    </message>
    <message>
      <source>start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχικό σημείο</translation>
    </message>
    <message>
      <source>turning by hand</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στροφή με το χέρι</translation>
    </message>
    <message>
      <source>A back alone has no closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια πίσω όψη μόνη δεν έχει κλειστό μοντέλο.</translation>
    </message>
    <message>
      <source>Cancelled. The back stays where it was.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακόπηκε· η πίσω όψη μένει όπου ήταν.</translation>
    </message>
    <message>
      <source>What was only tried is gone: its pairs were closed since.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι ήταν μόνο δοκιμή δεν υπάρχει πια· τα ζεύγη του έκλεισαν στο μεταξύ.</translation>
    </message>
    <message>
      <source>The fractures do not touch here.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι θραύσεις δεν ακουμπούν εδώ.</translation>
    </message>
    <message>
      <source>Fractures %1 apart, %2 of them touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Θραύσεις σε απόσταση %1, ακουμπά το %2.</translation>
    </message>
    <message>
      <source>Turned by hand; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στράφηκε με το χέρι· το B βελτιώνει την προσαρμογή.</translation>
    </message>
    <message>
      <source>Start point %1; B refines the fit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχικό σημείο %1· το B βελτιώνει την προσαρμογή.</translation>
    </message>
    <message>
      <source>refining the fit</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>βελτίωση της προσαρμογής</translation>
    </message>
    <message>
      <source>This pair has no closed model yet. Reprocess the batch to make it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το ζεύγος δεν έχει ακόμη κλειστό μοντέλο. Επανεπεξεργαστείτε την παρτίδα για να γίνει.</translation>
    </message>
    <message>
      <source>This back has no partner.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η πίσω όψη είναι μόνη.</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φόρτωση…</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CardListModel</name>
    <message>
      <source>%1, %2. %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2. %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PairReview</name>
    <message>
      <source>Choose a back first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε πρώτα πίσω όψη.</translation>
    </message>
    <message>
      <source>Enter your initials first: each decision keeps its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γράψτε πρώτα τα αρχικά σας: κάθε απόφαση κρατά το όνομά της.</translation>
    </message>
    <message>
      <source>pair %1 – %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ζεύγος %1 – %2</translation>
    </message>
    <message>
      <source>setting aside %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το %1 στην άκρη</translation>
    </message>
    <message>
      <source>No pair is chosen: give this back to a front first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν επιλέχθηκε ζεύγος: δώστε πρώτα αυτή την πίσω όψη σε μια μπροστινή.</translation>
    </message>
    <message>
        <source>reshooting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>νέα λήψη: %1</translation>
    </message>
    <message>
        <source>merging %1 and %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>συγχώνευση %1 και %2</translation>
    </message>
    <message>
        <source>splitting %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>διαίρεση: %1</translation>
    </message>
    <message>
      <source>One of the two has no back to merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το ένα από τα δύο δεν έχει πίσω όψη για συγχώνευση.</translation>
    </message>
    <message>
      <source>A pair can be decided once it is shown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Για ένα ζεύγος μπορείτε να αποφασίσετε μόλις εμφανιστεί.</translation>
    </message>
    <message>
      <source>All pairs of this batch are decided.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλα τα ζεύγη αυτής της παρτίδας έχουν αποφασιστεί.</translation>
    </message>
    <message>
      <source>Saved. Check %1 – %2: only %3 of their fractures touch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Ελέγξτε %1 – %2: ακουμπά μόνο το %3 των θραύσεών τους.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PicturePair</name>
    <message>
      <source>Photographs of both sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες και των δύο όψεων</translation>
    </message>
    <message>
      <source>Front %1, back %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστά %1, πίσω %2</translation>
    </message>
    <message>
      <source>The photograph is not there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία λείπει.</translation>
    </message>
    <message>
      <source>front %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστά %1</translation>
    </message>
    <message>
      <source>back %1, mirrored</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω %1, κατοπτρικά</translation>
    </message>
    <message>
      <source>back %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω %1</translation>
    </message>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
      <source>Line over the %1, %2 steps from its middle, turned by %3 degrees</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γραμμή πάνω στο %1, %2 βήματα από το μέσο, στραμμένη κατά %3 μοίρες</translation>
    </message>
    <message>
      <source>Arrows move the line, with Shift they turn it, Up or Down takes the other side, Enter cuts. Or draw a line with the mouse.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα βέλη μετακινούν τη γραμμή, με Shift τη στρέφουν, Πάνω ή Κάτω παίρνει την άλλη όψη, Enter κόβει. Ή σχεδιάστε γραμμή με το ποντίκι.</translation>
    </message>
    <message>
      <source>Loading…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φόρτωση…</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlaceEdit</name>
    <message>
      <source>&amp;Bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Σακούλα</translation>
    </message>
    <message>
      <source>Site, trench, context and bag</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Θέση, τομή, πλαίσιο και σακούλα</translation>
    </message>
    <message>
      <source>New: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα: %1</translation>
    </message>
    <message>
      <source>scan its label, or %1-T3-0012-4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σαρώστε την ετικέτα, ή %1-T3-0012-4</translation>
    </message>
    <message>
      <source>Write the bag as site-trench-context-bag.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γράψτε τη σακούλα ως θέση-τομή-πλαίσιο-σακούλα.</translation>
    </message>
    <message>
      <source>No bag: the sherds can be numbered once the catalogue gives them a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς σακούλα: τα όστρακα μπορούν να αριθμηθούν όταν ο κατάλογος τους δώσει πλαίσιο.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateView</name>
    <message>
      <source>Picture of the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα του δίσκου</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Φαίνεται %n όστρακο</numerusform>
        <numerusform>Φαίνονται %n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>5 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>5 εκ.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::QueueScreen</name>
    <message>
      <source>This batch has no masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα δεν έχει μάσκες.</translation>
    </message>
    <message>
      <source>Pause</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παύση</translation>
    </message>
    <message>
      <source>Log</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ημερολόγιο</translation>
    </message>
    <message>
      <source>Batches</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδες</translation>
    </message>
    <message>
      <source>Log of the computation</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ημερολόγιο υπολογισμού</translation>
    </message>
    <message>
      <source>No batch yet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία παρτίδα ακόμη</translation>
    </message>
    <message>
      <source>Queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ουρά</translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n παρτίδα σταμάτησε και σας χρειάζεται</numerusform>
        <numerusform>%n παρτίδες σταμάτησαν και σας χρειάζονται</numerusform>
      </translation>
    </message>
    <message>
      <source>%1 has no report yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 δεν έχει ακόμη αναφορά.</translation>
    </message>
    <message>
      <source>Drafts first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρώτα προσχέδια</translation>
    </message>
    <message>
      <source>A camera was bumped: this batch's photographs tell where the cameras stand now (C)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια κάμερα μετακινήθηκε: οι φωτογραφίες της παρτίδας δείχνουν πού είναι τώρα (C)</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επανεπεξεργασία</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εμφάνιση αναφοράς</translation>
    </message>
    <message>
        <source>Review</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>Edit masks</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επεξεργασία μασκών</translation>
    </message>
    <message>
        <source>Open</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Άνοιγμα</translation>
    </message>
    <message>
        <source>Processes each new batch quickly and coarsely, for a check while the sherds are still on the plate; reprocessing makes it final (D)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επεξεργάζεται κάθε νέα παρτίδα γρήγορα και αδρά, για έλεγχο όσο τα όστρακα είναι στην πλάκα· η επανεπεξεργασία την οριστικοποιεί (D)</translation>
    </message>
    <message>
        <source>Recalibrate rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Νέα βαθμονόμηση διάταξης</translation>
    </message>
    <message>
        <source>What you photograph or import is processed here, one batch after the other, while you go on working.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ό,τι φωτογραφίζετε ή εισάγετε επεξεργάζεται εδώ, μία παρτίδα τη φορά, ενώ συνεχίζετε.</translation>
    </message>
    <message>
        <source>Batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Παρτίδα</translation>
    </message>
    <message>
        <source>Resume</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συνέχεια</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Στην άκρη</translation>
    </message>
    <message>
        <source>Cancel %1?</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ακύρωση του %1;</translation>
    </message>
    <message>
        <source>It has been processing for more than an hour. Finished stages are saved; the current one is lost.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η επεξεργασία διαρκεί πάνω από μία ώρα. Τα ολοκληρωμένα στάδια είναι αποθηκευμένα· το τρέχον χάνεται.</translation>
    </message>
    <message>
        <source>Cancel it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>Keep processing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συνέχιση επεξεργασίας</translation>
    </message>
    <message>
      <source>Marker side…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλευρά δείκτη…</translation>
    </message>
    <message>
      <source>Keep both</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διατήρηση και των δύο</translation>
    </message>
    <message>
      <source>Processes this batch although another one has the same photographs; the sherds of both are then in the catalogue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επεξεργάζεται αυτή την παρτίδα, αν και μια άλλη έχει τις ίδιες φωτογραφίες· τα όστρακα και των δύο βρίσκονται τότε στον κατάλογο</translation>
    </message>
    <message>
      <source>The report of %1 is not opened: this version of Ostraka did not write it, and it may run scripts. Reprocess the batch to write it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αναφορά της %1 δεν ανοίγει: δεν την έγραψε αυτή η έκδοση του Ostraka και μπορεί να εκτελέσει σενάρια. Επεξεργαστείτε ξανά την παρτίδα για να γραφτεί εκ νέου.</translation>
    </message>
    <message>
        <source>The queue is paused: this project was restored from an archive.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η ουρά είναι σε παύση: αυτό το έργο προέρχεται από επαναφορά αρχείου έργου.</translation>
    </message>
    <message>
        <source>Its batches that are not processed yet wait until you resume it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Οι παρτίδες που δεν έχουν υποβληθεί ακόμη σε επεξεργασία περιμένουν ώσπου να τη συνεχίσετε.</translation>
    </message>
    <message>
        <source>Photographs are being imported; their batch appears here when all of them are copied.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εισάγονται φωτογραφίες· η παρτίδα τους εμφανίζεται εδώ όταν αντιγραφούν όλες.</translation>
    </message>
    <message>
        <source>Show the import</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εμφάνιση της εισαγωγής</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::Sidebar</name>
    <message>
      <source>%1  %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1  %2</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Screens</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οθόνες</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewPane</name>
    <message>
      <source>Pairs, most doubtful first</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ζεύγη, τα πιο αμφίβολα πρώτα</translation>
    </message>
    <message>
      <source>Next pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενο ζεύγος</translation>
    </message>
    <message>
      <source>Previous pair</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προηγούμενο ζεύγος</translation>
    </message>
    <message>
      <source>Candidate %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υποψήφιο %1</translation>
    </message>
    <message>
      <source>Start point before</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Προηγούμενο αρχικό σημείο</translation>
    </message>
    <message>
      <source>Next start point</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενο αρχικό σημείο</translation>
    </message>
    <message>
      <source>One sample back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα δείγμα πίσω</translation>
    </message>
    <message>
      <source>One sample on</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα δείγμα μπροστά</translation>
    </message>
    <message>
      <source>Mirror back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κατοπτρικά</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή</translation>
    </message>
    <message>
      <source>Measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέτρηση</translation>
    </message>
    <message>
      <source>Model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλο</translation>
    </message>
    <message>
      <source>Set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στην άκρη</translation>
    </message>
    <message>
      <source>… and the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>… και το άλλο άκρο</translation>
    </message>
    <message>
      <source>Pairs of the batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ζεύγη της παρτίδας</translation>
    </message>
    <message>
      <source>Click on one end of the length on the sherd, then on the other. D ends.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάντε κλικ στο ένα άκρο του μήκους πάνω στο όστρακο, μετά στο άλλο. Το D τελειώνει.</translation>
    </message>
    <message>
        <source>Accept</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αποδοχή</translation>
    </message>
    <message>
        <source>Leave merging and splitting</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Έξοδος από συγχώνευση και διαίρεση</translation>
    </message>
    <message>
        <source>Refine fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Βελτίωση εφαρμογής</translation>
    </message>
    <message>
        <source>Refine the position by the fracture surfaces (B)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Βελτίωση θέσης με βάση τις θραύσεις (B)</translation>
    </message>
    <message>
        <source>Reshoot</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Νέα λήψη</translation>
    </message>
    <message>
        <source>View</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Προβολή</translation>
    </message>
    <message>
        <source>Fit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εφαρμογή</translation>
    </message>
    <message>
        <source>Decide</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Απόφαση</translation>
    </message>
    <message>
        <source>Explode</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διαχωρισμός</translation>
    </message>
    <message>
        <source>Fracture gap</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Κενό θραύσης</translation>
    </message>
    <message>
        <source>Split</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διαίρεση</translation>
    </message>
    <message>
        <source>Split a scan of two sherds along a line over its photograph (K)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διαίρεση σάρωσης δύο οστράκων κατά μήκος γραμμής στη φωτογραφία (K)</translation>
    </message>
    <message>
        <source>Merge</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συγχώνευση</translation>
    </message>
    <message>
        <source>Merge two fragments of one sherd: then choose the other card (J fronts, Shift+J backs)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συγχώνευση δύο θραυσμάτων ενός οστράκου: επιλέξτε μετά την άλλη κάρτα (J μπροστινές όψεις, Shift+J πίσω όψεις)</translation>
    </message>
    <message>
        <source>Merge backs</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Συγχώνευση πίσω όψεων</translation>
    </message>
    <message>
      <source>Comparing the fractures… Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση των θραύσεων … Το Esc διακόπτει.</translation>
    </message>
    <message>
      <source>Refining the fit, fracture gap %1. Esc stops.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βελτίωση της προσαρμογής, κενό θραύσης %1. Το Esc διακόπτει.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ReviewScreen</name>
    <message>
      <source>Your &amp;initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα &amp;αρχικά σας</translation>
    </message>
    <message>
      <source>Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά σας</translation>
    </message>
    <message>
      <source>Review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>Update changed models</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ενημέρωση αλλαγμένων μοντέλων</translation>
    </message>
    <message>
        <source>Reprocesses the pairs that were decided differently</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επανεπεξεργάζεται τα ζεύγη που αποφασίστηκαν αλλιώς</translation>
    </message>
    <message>
        <source>No pairs to review yet</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δεν υπάρχουν ακόμη ζεύγη για έλεγχο</translation>
    </message>
    <message>
        <source>Photograph or import a batch. Its pairs appear here when it is processed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φωτογραφίστε ή εισαγάγετε μια παρτίδα. Τα ζεύγη εμφανίζονται εδώ μετά την επεξεργασία.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εμφάνιση αναφοράς</translation>
    </message>
    <message>
        <source>%1 was reshot as %2 in %3 and now has two records. Void one of them in the catalogue, or set the fragment aside here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Το %1 φωτογραφήθηκε ξανά ως %2 στο %3 και έχει τώρα δύο εγγραφές. Ακυρώστε μία στον κατάλογο ή αφήστε εδώ το θραύσμα στην άκρη.</translation>
    </message>
    <message>
      <source>%1 is queued; only what changed is reprocessed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 είναι σε αναμονή· επανεπεξεργάζεται μόνο ό,τι άλλαξε.</translation>
    </message>
    <message>
      <source>Saved. Pairs of the new fragments appear after reprocessing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Τα ζεύγη των νέων θραυσμάτων εμφανίζονται μετά την επανεπεξεργασία.</translation>
    </message>
    <message>
      <source>Undone. The history keeps both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανακλήθηκε. Και τα δύο μένουν στο ιστορικό.</translation>
    </message>
    <message>
      <source>No pairs to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχουν ζεύγη για έλεγχο</translation>
    </message>
    <message numerus="yes">
      <source>%n pair(s) to review</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n ζεύγος για έλεγχο</numerusform>
        <numerusform>%n ζεύγη για έλεγχο</numerusform>
      </translation>
    </message>
    <message>
      <source>No measurement of %1 is certain. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία μέτρηση της %1 δεν είναι βέβαιη. %2</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd has no number, and %1 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Μετά την επανεπεξεργασία το συγχωνευμένο όστρακο δεν έχει αριθμό και ο %1 δεν έχει θραύσμα. Η αναίρεση τα χωρίζει πάλι.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, the merged sherd keeps the number %1, and %2 has no fragment. Undo separates them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Μετά την επανεπεξεργασία το συγχωνευμένο όστρακο κρατά τον αριθμό %1 και ο %2 δεν έχει θραύσμα. Η αναίρεση τα χωρίζει πάλι.</translation>
    </message>
    <message>
      <source>%1 has no scale: no length shown here is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στην %1 δεν είναι γνωστό κανένα μήκος: κανένας αριθμός και κανένα μήκος εδώ δεν είναι σε χιλιοστά.</translation>
    </message>
    <message>
      <source>Saved. After reprocessing, number %1 goes to the half that it was typed on, or else to the larger one. Undo merges them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Μετά την επανεπεξεργασία ο αριθμός %1 πηγαίνει στο μισό όπου πληκτρολογήθηκε, αλλιώς στο μεγαλύτερο. Η αναίρεση τα συγχωνεύει πάλι.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: the sherds in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Όλα τα ζεύγη της %1 έχουν αποφασιστεί. Επόμενο: τα όστρακα στον κατάλογο.</translation>
    </message>
    <message>
      <source>Saved. All pairs of %1 are decided. Next: update the changed models.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε. Όλα τα ζεύγη της %1 έχουν αποφασιστεί. Επόμενο: ενημέρωση των μοντέλων που άλλαξαν.</translation>
    </message>
    <message>
      <source>Saved, with your initials.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε, με τα αρχικά σας.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::RigPage</name>
    <message>
      <source>Two of them look alike</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο από αυτά μοιάζουν</translation>
    </message>
    <message>
      <source>What do you photograph with?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Με τι φωτογραφίζετε;</translation>
    </message>
    <message>
      <source>Use the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρήση της εικονικής διάταξης</translation>
    </message>
    <message>
      <source>Choose a rig file…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή αρχείου διάταξης…</translation>
    </message>
    <message>
      <source>Import photographs…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή φωτογραφιών…</translation>
    </message>
    <message>
      <source>Import scans…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγωγή σαρώσεων…</translation>
    </message>
    <message>
      <source>The virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικονική διάταξη</translation>
    </message>
    <message>
      <source>small: a batch in a minute or two</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μικρές: μια παρτίδα σε ένα-δύο λεπτά</translation>
    </message>
    <message>
      <source>normal</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κανονικές</translation>
    </message>
    <message>
      <source>fine: as a real camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λεπτομερείς: όπως μια αληθινή κάμερα</translation>
    </message>
    <message>
      <source>&amp;Sherds on the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Όστρακα στον δίσκο</translation>
    </message>
    <message>
      <source>&amp;Photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Φωτογραφίες</translation>
    </message>
    <message>
      <source>%1 pixels wide</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλάτος %1 εικονοστοιχεία</translation>
    </message>
    <message>
      <source>Rig file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχείο διάταξης</translation>
    </message>
    <message>
      <source>Rig (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάταξη (*.json)</translation>
    </message>
    <message>
      <source>Space</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διάστημα</translation>
    </message>
    <message>
        <source>Keep current rig</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Διατήρηση τρέχουσας διάταξης</translation>
    </message>
    <message>
      <source>Import photographs taken by hand, or choose a rig file (RIG.json), which names your cameras and your turntable. The virtual rig is for practice: its sherds are invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εισαγάγετε φωτογραφίες που τραβήχτηκαν με το χέρι ή επιλέξτε αρχείο διάταξης (RIG.json), που ονομάζει τις κάμερες και την περιστρεφόμενη τράπεζα. Η εικονική διάταξη είναι για εξάσκηση: τα όστρακά της είναι επινοημένα.</translation>
    </message>
    <message>
      <source>No rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία διάταξη</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακύρωση</translation>
    </message>
    <message>
      <source>Use the virtual rig in this project?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρήση της εικονικής διάταξης σε αυτό το έργο;</translation>
    </message>
    <message>
      <source>It is for practice: its sherds are invented, and they enter this project's catalogue. The queue marks its batches as invented.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι για εξάσκηση: τα όστρακά της είναι επινοημένα και μπαίνουν στον κατάλογο αυτού του έργου. Η ουρά σημειώνει τις παρτίδες της ως επινοημένες.</translation>
    </message>
    <message>
        <source>Importing</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Γίνεται εισαγωγή</translation>
    </message>
    <message>
        <source>The batch goes into the queue when all of its files are copied. Meanwhile you can choose a rig.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η παρτίδα μπαίνει στην ουρά όταν αντιγραφούν όλα τα αρχεία της. Στο μεταξύ μπορείτε να επιλέξετε διάταξη.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectEdit</name>
    <message>
      <source>As photographed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όπως φωτογραφήθηκε</translation>
    </message>
    <message>
      <source>Without the light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς το φως</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανοιχτό έργο</translation>
    </message>
    <message>
      <source>Na&amp;me</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό&amp;νομα</translation>
    </message>
    <message>
      <source>Site &amp;code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Κωδικός θέσης</translation>
    </message>
    <message>
      <source>Textures of new mo&amp;dels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υ&amp;φές νέων μοντέλων</translation>
    </message>
    <message>
      <source>rename the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μετονομασία του έργου</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε.</translation>
    </message>
    <message>
      <source>change the textures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή των υφών</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::RightsEdit</name>
    <message>
      <source>Rights to the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δικαιώματα στο ανοιχτό έργο</translation>
    </message>
    <message>
      <source>for instance CC-BY-4.0; empty: none is named</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>για παράδειγμα CC-BY-4.0· κενό: δεν δηλώνεται καμία</translation>
    </message>
    <message>
      <source>&amp;Licence of what is exported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ά&amp;δεια των εξαγωγών</translation>
    </message>
    <message>
      <source>Who &amp;holds the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ποιος έχει τα δικα&amp;ιώματα</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε.</translation>
    </message>
    <message>
      <source>change the rights</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή δικαιωμάτων</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SettingsPage</name>
    <message>
      <source>Light</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτεινό</translation>
    </message>
    <message>
      <source>Dark, for the tent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σκούρο, για τη σκηνή</translation>
    </message>
    <message>
      <source>Sunlight: black on white, thick lines</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ηλιόφως: μαύρο σε άσπρο, παχιές γραμμές</translation>
    </message>
    <message>
      <source>all</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όλα</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίσεις</translation>
    </message>
    <message>
      <source>&amp;Your initials</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα &amp;αρχικά σας</translation>
    </message>
    <message>
      <source>&amp;Theme</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Θέμα</translation>
    </message>
    <message>
      <source>Te&amp;xt size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Μέγεθος κειμένου</translation>
    </message>
    <message>
      <source>Text size</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μέγεθος κειμένου</translation>
    </message>
    <message>
      <source>&amp;Language</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Γλώσσα</translation>
    </message>
    <message>
      <source>&amp;Processors for computing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Επεξεργαστές για υπολογισμό</translation>
    </message>
    <message>
      <source>%1 %</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 %</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Όπως το σύστημα</translation>
    </message>
    <message>
        <source>Recorded with each decision.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Καταγράφονται σε κάθε απόφαση.</translation>
    </message>
    <message>
        <source>Takes effect after restart.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ισχύει μετά την επανεκκίνηση.</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Πίσω (Esc)</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επανεκκίνηση</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SheetView</name>
    <message>
      <source>The drawing on its sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το σχέδιο στο φύλλο του</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdDetails</name>
    <message>
      <source>missing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>λείπει</translation>
    </message>
    <message>
      <source>changed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>άλλαξε</translation>
    </message>
    <message>
      <source>present</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>υπάρχει</translation>
    </message>
    <message>
      <source>Details of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στοιχεία του οστράκου</translation>
    </message>
    <message>
      <source>Number of the sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμός του οστράκου</translation>
    </message>
    <message>
      <source>Picture of the sherd in the way</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνα του οστράκου που εμποδίζει</translation>
    </message>
    <message>
      <source>measure</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέτρο</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τιμή</translation>
    </message>
    <message>
      <source>from</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προέλευση</translation>
    </message>
    <message>
      <source>Measurements</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήσεις</translation>
    </message>
    <message>
      <source>when</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πότε</translation>
    </message>
    <message>
      <source>who</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ποιος</translation>
    </message>
    <message>
      <source>what</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τι</translation>
    </message>
    <message>
      <source>History</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ιστορικό</translation>
    </message>
    <message>
      <source>file</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αρχείο</translation>
    </message>
    <message>
      <source>kind</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>είδος</translation>
    </message>
    <message>
      <source>state</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατάσταση</translation>
    </message>
    <message>
      <source>Files</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχεία</translation>
    </message>
    <message>
      <source>Measured</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρημένα</translation>
    </message>
    <message>
      <source>Context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλαίσιο</translation>
    </message>
    <message>
      <source>context</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πλαίσιο</translation>
    </message>
    <message>
      <source>added</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προστέθηκε</translation>
    </message>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>%1: %2 → %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 → %3</translation>
    </message>
    <message>
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τίποτα</translation>
    </message>
    <message>
      <source>program</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πρόγραμμα</translation>
    </message>
    <message>
      <source>Choose a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε όστρακο.</translation>
    </message>
    <message>
      <source>%1 It is %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 Είναι το %2.</translation>
    </message>
    <message>
      <source>%1; in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1· αμφίβολο</translation>
    </message>
    <message>
      <source>7 is the running number in the sherd&apos;s context; =7 is the number 7 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7 είναι ο αύξων αριθμός στο πλαίσιο του οστράκου· =7 είναι ο ίδιος ο αριθμός 7.</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επιβεβαίωση</translation>
    </message>
    <message>
        <source>computed; replaced by the measured value</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>υπολογισμένη· αντικαταστάθηκε από τη μετρημένη τιμή</translation>
    </message>
    <message>
      <source>Assign number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Απόδοση του αριθμού %1</translation>
    </message>
    <message>
      <source>Numbering…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρίθμηση…</translation>
    </message>
    <message>
      <source>photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φωτογραφία</translation>
    </message>
    <message>
      <source>mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μάσκα</translation>
    </message>
    <message>
      <source>scan</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σάρωση</translation>
    </message>
    <message>
      <source>model</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μοντέλο</translation>
    </message>
    <message>
      <source>picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εικόνα</translation>
    </message>
    <message>
      <source>drawing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σχέδιο</translation>
    </message>
    <message>
      <source>report</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αναφορά</translation>
    </message>
    <message>
      <source>scale</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κλίμακα</translation>
    </message>
    <message>
      <source>Not saved yet: %1. Enter in the field saves it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν αποθηκεύτηκε ακόμη: %1. Το Enter στο πεδίο το αποθηκεύει.</translation>
    </message>
    <message>
      <source>-0599/-0549: 600 to 550 BC</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>-0599/-0549: 600 έως 550 π.Χ.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdEdits</name>
    <message>
      <source>Other changes are still being saved; wait for them, or stop them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύονται ακόμη άλλες αλλαγές· περιμένετε, ή διακόψτε τες.</translation>
    </message>
    <message>
      <source>The sherds that are chosen have their numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα επιλεγμένα όστρακα έχουν τους αριθμούς τους.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) got no number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο δεν πήρε αριθμό: %1</numerusform>
        <numerusform>%n όστρακα δεν πήραν αριθμό: %1</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>numbering of %n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>αρίθμηση %n οστράκου</numerusform>
        <numerusform>αρίθμηση %n οστράκων</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was changed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακυρώθηκε. Δεν άλλαξε τίποτα.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdTableModel</name>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>not recorded</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν καταγράφηκε</translation>
    </message>
    <message>
      <source>%1: %2, in doubt</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2, αμφίβολο</translation>
    </message>
    <message>
      <source>%1: the scale of batch %2 is in doubt; its report says why and what to do.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: η κλίμακα της παρτίδας %2 είναι αμφίβολη· η αναφορά της λέει γιατί και τι να γίνει.</translation>
    </message>
    <message>
        <source>%1: measured by hand; the computed value is kept beside it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: μετρημένο με το χέρι· η υπολογισμένη τιμή διατηρείται δίπλα.</translation>
    </message>
    <message>
        <source>%1: %2, measured by hand</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: %2, μετρημένο με το χέρι</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdView</name>
    <message>
      <source>Sherd in three dimensions</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο σε τρεις διαστάσεις</translation>
    </message>
    <message>
      <source>This screen has no OpenGL 3.2, so the sherd cannot be shown in three dimensions. Everything else works; photographs and outlines are beside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η οθόνη δεν έχει OpenGL 3.2, οπότε το όστρακο δεν φαίνεται σε τρεις διαστάσεις. Όλα τα άλλα λειτουργούν· φωτογραφίες και περιγράμματα είναι δίπλα.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::StartScreen</name>
    <message>
      <source>Ostraka</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ostraka</translation>
    </message>
    <message>
      <source>Potsherds, both sides, complete and measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα, και οι δύο όψεις, πλήρη και μετρημένα.</translation>
    </message>
    <message>
      <source>&amp;Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Έργα</translation>
    </message>
    <message>
      <source>Try with the virtual rig</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δοκιμή με την εικονική διάταξη</translation>
    </message>
    <message>
      <source>New project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέο έργο</translation>
    </message>
    <message>
      <source>Aragats 2026</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Aragats 2026</translation>
    </message>
    <message>
      <source>Choose…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή…</translation>
    </message>
    <message>
      <source>Choose the folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή του φακέλου</translation>
    </message>
    <message>
      <source>&amp;Name</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό&amp;νομα</translation>
    </message>
    <message>
      <source>&amp;Site code</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κωδικός &amp;θέσης</translation>
    </message>
    <message>
      <source>&amp;Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Φάκελος</translation>
    </message>
    <message>
      <source>Folder</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Α&amp;ρίθμηση</translation>
    </message>
    <message>
      <source>%1
%2, %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
%2, %3</translation>
    </message>
    <message>
      <source>Folder of the new project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος του νέου έργου</translation>
    </message>
    <message>
      <source>Folder of a project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος ενός έργου</translation>
    </message>
    <message>
      <source>Projects</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έργα</translation>
    </message>
    <message>
      <source>Where is %1 now?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πού είναι τώρα το %1;</translation>
    </message>
    <message>
      <source>Settings</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ρυθμίσεις</translation>
    </message>
    <message>
      <source>Help</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Βοήθεια</translation>
    </message>
    <message>
        <source>Create project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δημιουργία έργου</translation>
    </message>
    <message>
        <source>Example</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Παράδειγμα</translation>
    </message>
    <message>
        <source>OK</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>OK</translation>
    </message>
    <message>
        <source>Repair the catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επισκευή του καταλόγου</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Άνοιγμα του έργου</translation>
    </message>
    <message>
      <source>%1
%2 is not there: find it…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1
Το %2 δεν υπάρχει: βρείτε το …</translation>
    </message>
    <message>
      <source>Enter</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Enter</translation>
    </message>
    <message>
        <source>No project yet. Import photographs of both sides of your sherds, or drop their folders here: a project is created for them. To practise, try the virtual rig: it breaks a pot and photographs its sherds for you.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δεν υπάρχει ακόμη έργο. Εισαγάγετε φωτογραφίες και των δύο όψεων των οστράκων σας ή αφήστε εδώ τους φακέλους τους: δημιουργείται έργο για αυτές. Για εξάσκηση, δοκιμάστε την εικονική διάταξη: σπάζει ένα αγγείο και φωτογραφίζει τα όστρακά του.</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εισαγωγή φωτογραφιών…</translation>
    </message>
    <message>
        <source>Creates a project named after their folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δημιουργεί έργο με το όνομα του φακέλου τους</translation>
    </message>
    <message>
        <source>Folder of the photographs: both sides, or a folder for each side within it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φάκελος των φωτογραφιών: και οι δύο όψεις ή ένας φάκελος για κάθε όψη</translation>
    </message>
    <message>
        <source>&amp;Restore an archive…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>&amp;Επαναφορά αρχείου έργου…</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επαναφορά…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>Restoring the project to %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επαναφορά του έργου στο %1</translation>
    </message>
    <message>
        <source>Folder of the archive</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φάκελος του αρχείου έργου</translation>
    </message>
    <message>
        <source>Where to put the project: an empty folder, or one for a new folder</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Πού θα μπει το έργο: ένας κενός φάκελος ή ένας για νέο φάκελο</translation>
    </message>
    <message>
      <source>&amp;Open from folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Άνοιγμα από φάκελο…</translation>
    </message>
    <message>
      <source>Open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα έργου</translation>
    </message>
    <message numerus="yes">
      <source>%1; %n batch(es) unfinished</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1· %n παρτίδα ημιτελής</numerusform>
        <numerusform>%1· %n παρτίδες ημιτελείς</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::StopBoard</name>
    <message>
      <source>Photographs of this side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες αυτής της όψης</translation>
    </message>
    <message>
      <source>%1 of %2 positions done</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έγιναν %1 από %2 στάσεις</translation>
    </message>
    <message>
      <source>%1 of %2 calibration photographs taken</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λήφθηκαν %1 από %2 φωτογραφίες βαθμονόμησης</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ViewOverlay</name>
    <message>
      <source>%1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 mm</translation>
    </message>
    <message>
        <source>Front</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μπροστινή όψη</translation>
    </message>
    <message>
        <source>Back</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Πίσω όψη</translation>
    </message>
    <message>
        <source>No scale: lengths are not known</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Χωρίς κλίμακα: τα μήκη δεν είναι γνωστά</translation>
    </message>
    <message>
        <source>no contact</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>χωρίς επαφή</translation>
    </message>
    <message>
        <source>filled in, not seen by a camera</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>συμπληρωμένο, δεν το είδε κάμερα</translation>
    </message>
    <message>
        <source>Distance between the sides along the fracture</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Απόσταση των όψεων κατά μήκος της θραύσης</translation>
    </message>
    <message>
        <source>front outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>μπροστινή όψη έξω κατά %1</translation>
    </message>
    <message>
        <source>back outside by %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>πίσω όψη έξω κατά %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberEdit</name>
    <message>
      <source>7, the whole number, or scan its label</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>7, ολόκληρος αριθμός ή σάρωση της ετικέτας</translation>
    </message>
    <message>
      <source>&amp;Number of sherd %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Αριθμός του οστράκου %1</translation>
    </message>
    <message>
      <source>If they have numbers already: each follows its sherd through the flip. Key N.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αν έχουν ήδη αριθμούς: ο καθένας ακολουθεί το όστρακό του στο γύρισμα. Πλήκτρο N.</translation>
    </message>
    <message>
      <source>Sherd %1 got no number. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο %1 δεν πήρε αριθμό. %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskModel</name>
    <message>
      <source>back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πίσω όψη</translation>
    </message>
    <message>
      <source>front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μπροστινή όψη</translation>
    </message>
    <message>
      <source>paint on a mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ζωγραφική σε μάσκα</translation>
    </message>
    <message>
      <source>%1, camera %2, position %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, κάμερα %2, στάση %3</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskPage</name>
    <message>
      <source>Masks of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μάσκες του %1</translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω</translation>
    </message>
    <message>
      <source>Brush's &amp;width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Πλάτος πινέλου</translation>
    </message>
    <message>
      <source>Larger</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μεγέθυνση</translation>
    </message>
    <message>
      <source>Smaller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σμίκρυνση</translation>
    </message>
    <message>
      <source>Next photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επόμενη φωτογραφία</translation>
    </message>
    <message>
      <source>Photograph</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφία</translation>
    </message>
    <message>
      <source>Plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δίσκος</translation>
    </message>
    <message>
      <source>Sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο</translation>
    </message>
    <message>
        <source>Previous photograph</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Προηγούμενη φωτογραφία</translation>
    </message>
    <message>
        <source>Reprocess</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Επανεπεξεργασία</translation>
    </message>
    <message>
        <source>Brush</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Πινέλο</translation>
    </message>
    <message>
        <source>Loading photograph…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Φόρτωση φωτογραφίας…</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) edited. Reprocess to update what follows from them.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>
            <numerusform>Άλλαξε %n φωτογραφία. Επανεπεξεργαστείτε για ενημέρωση.</numerusform>
            <numerusform>Άλλαξαν %n φωτογραφίες. Επανεπεξεργαστείτε για ενημέρωση.</numerusform>
        </translation>
    </message>
    <message>
        <source>Blue: classified as sherd. Paint missing parts as sherd and wrong ones as plate; the program&apos;s own masks stay.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μπλε: αναγνωρίστηκε ως όστρακο. Βάψτε ό,τι λείπει ως όστρακο και τα λάθη ως πλάκα· οι μάσκες του προγράμματος μένουν.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MaskView</name>
    <message>
      <source>Photograph with its mask</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφία με τη μάσκα της</translation>
    </message>
    <message>
      <source>The arrows move the brush, Space paints, plus and minus enlarge and reduce.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα βέλη μετακινούν το πινέλο, το διάστημα ζωγραφίζει, το συν και το πλην μεγεθύνουν και σμικρύνουν.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberingEdit</name>
    <message>
      <source>First number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρώτος αριθμός αυτού του υπολογιστή</translation>
    </message>
    <message>
      <source>Last number of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τελευταίος αριθμός αυτού του υπολογιστή</translation>
    </message>
    <message>
      <source>N&amp;umbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Α&amp;ρίθμηση</translation>
    </message>
    <message>
      <source>Num&amp;bers of this computer</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί αυτού του &amp;υπολογιστή</translation>
    </message>
    <message>
      <source>Numbers of the open project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί του ανοιχτού έργου</translation>
    </message>
    <message>
      <source>What has a number keeps it; the next sherds follow. No number is ever given twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι έχει αριθμό τον κρατά· τα επόμενα όστρακα ακολουθούν. Κανένας αριθμός δεν δίνεται δύο φορές.</translation>
    </message>
    <message numerus="yes">
      <source>and in %n more context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>και σε %n ακόμη πλαίσιο</numerusform>
        <numerusform>και σε %n ακόμη πλαίσια</numerusform>
      </translation>
    </message>
    <message>
      <source>to</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έως</translation>
    </message>
    <message>
      <source>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, and {n} once; {n:04} has four digits at least</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>{site} {trench} {context} {bag} {batch} {yyyy} {yy}, και {n} μία φορά· το {n:04} έχει τουλάχιστον τέσσερα ψηφία</translation>
    </message>
    <message>
      <source>Example</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο θα είναι</translation>
    </message>
    <message>
      <source>Use this &amp;numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρίθμηση έτσι από εδώ και &amp;πέρα</translation>
    </message>
    <message>
      <source>Skipped numbers</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί που παραλείφθηκαν</translation>
    </message>
    <message>
      <source>none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κανένας</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NumberingModel</name>
    <message>
      <source>%1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2</translation>
    </message>
    <message>
      <source>Sherds of %1 get no number so: it lacks a part that the numbering names.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα του %1 δεν παίρνουν έτσι αριθμό: του λείπει ένα μέρος που αναφέρει η αρίθμηση.</translation>
    </message>
    <message>
      <source>The first number of a block is not above its last.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πρώτος αριθμός μιας ομάδας δεν είναι πάνω από τον τελευταίο.</translation>
    </message>
    <message>
      <source>change the numbering</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή της αρίθμησης</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::VocabularyEdit</name>
    <message>
      <source>&amp;Words for</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Λέξεις για</translation>
    </message>
    <message>
      <source>A word that sherds use already stays; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια λέξη που ήδη χρησιμοποιούν όστρακα μένει· αλλάξτε πρώτα εκείνα.</translation>
    </message>
    <message>
      <source>Saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθηκεύτηκε.</translation>
    </message>
    <message>
      <source>condition</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διατήρηση</translation>
    </message>
    <message>
      <source>decoration</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διακόσμηση</translation>
    </message>
    <message>
      <source>firing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όπτηση</translation>
    </message>
    <message>
      <source>manufacture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κατασκευή</translation>
    </message>
    <message>
      <source>part</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέρος</translation>
    </message>
    <message>
      <source>surface</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>επιφάνεια</translation>
    </message>
    <message>
      <source>&amp;Save vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αποθήκευση λέ&amp;ξεων</translation>
    </message>
    <message>
      <source>&amp;One per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μ&amp;ία ανά γραμμή</translation>
    </message>
    <message>
      <source>Project vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λέξεις του ανοιχτού έργου</translation>
    </message>
    <message>
      <source>Terms, one per line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λέξεις, μία ανά γραμμή</translation>
    </message>
    <message>
      <source>change the vocabulary</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αλλαγή των λέξεων</translation>
    </message>
    <message>
      <source>These terms are not saved yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτές οι λέξεις δεν έχουν αποθηκευτεί ακόμη.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CountEdit</name>
    <message>
      <source>&amp;Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό&amp;στρακα</translation>
    </message>
    <message>
      <source>not counted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν μετρήθηκαν</translation>
    </message>
    <message>
      <source>How many sherds you counted onto the plate</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πόσα όστρακα μετρήσατε στον δίσκο</translation>
    </message>
    <message>
      <source>Count them if you like: you are asked when the photographs show another number (S)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήστε τα αν θέλετε: ερωτάστε όταν οι φωτογραφίες δείχνουν άλλον αριθμό (S)</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportLine</name>
    <message>
      <source>How far the import is</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της εισαγωγής</translation>
    </message>
    <message>
      <source>Stop the import</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή της εισαγωγής</translation>
    </message>
</context>
<context>
    <name>ImportBatch</name>
    <message>
      <source>There are no scans (*.ply) in its folder %1/. Choose a folder that holds front/ and back/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχουν σαρώσεις (*.ply) στον φάκελό του %1/. Επιλέξτε φάκελο που περιέχει front/ και back/.</translation>
    </message>
    <message>
      <source>This folder cannot be read to its end: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος δεν διαβάζεται ως το τέλος: %1.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SherdNumbers</name>
    <message>
      <source>%1 is no sherd's number: it has a digit, no space and at most %2 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 δεν είναι αριθμός οστράκου: έχει ένα ψηφίο, κανένα κενό και το πολύ %2 χαρακτήρες.</translation>
    </message>
    <message>
      <source>Sherd %1 of this plate has the number %2: take it from that one first, or type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο %1 αυτού του δίσκου έχει τον αριθμό %2: αφαιρέστε τον πρώτα από εκείνο ή γράψτε άλλον.</translation>
    </message>
    <message>
      <source>A sherd of %1 has the number %2 already; type another.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο της %1 έχει ήδη τον αριθμό %2· γράψτε άλλον.</translation>
    </message>
    <message>
      <source>Sherd %1: %2 is not as this bag's sherds are numbered (%3). If that is no slip, go on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1: το %2 δεν είναι όπως αριθμούνται τα όστρακα αυτής της σακούλας (%3). Αν δεν είναι λάθος, συνεχίστε.</translation>
    </message>
</context>
<context>
    <name>ostraka::Error</name>
    <message>
      <source>The disk has only %1 MB left, and a batch needs more. Nothing is lost: free some space, then resume.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στον σκληρό δίσκο μένουν μόνο %1 MB· μια παρτίδα χρειάζεται περισσότερα. Τίποτα δεν χάθηκε: κάντε χώρο και συνεχίστε.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but there is no sherd with a context in that place; assign it in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: αυτός ο αριθμός γράφτηκε πάνω στον δίσκο, αλλά εκεί δεν υπάρχει όστρακο με πλαίσιο· δώστε τον στον κατάλογο.</translation>
    </message>
    <message>
      <source>%1: this number was entered on the plate, but it belongs to another sherd; check which of the two bears it, and give the other one a new number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: ο αριθμός αυτός πληκτρολογήθηκε στην πλάκα, αλλά ανήκει σε άλλο όστρακο· δείτε ποιο από τα δύο τον φέρει και δώστε στο άλλο νέο αριθμό.</translation>
    </message>
    <message>
      <source>Pairs were decided or masks edited while the batch was being processed; reprocess it to apply them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όσο γινόταν η επεξεργασία της παρτίδας, αποφασίστηκαν ζεύγη ή άλλαξαν μάσκες· επανεπεξεργαστείτε την γι' αυτά.</translation>
    </message>
    <message>
      <source>Sherds counted on the plate: %1, but another number was found; check the map for a sherd that is missing or was split in two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα που μετρήθηκαν πάνω στον δίσκο: %1. Βρέθηκε άλλος αριθμός· αναζητήστε στον χάρτη αυτό που λείπει ή κόπηκε στα δύο.</translation>
    </message>
    <message>
      <source>Cancelled.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακυρώθηκε.</translation>
    </message>
    <message>
      <source>The camera is not plugged in or not switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν είναι συνδεδεμένη ή δεν είναι ανοιχτή.</translation>
    </message>
    <message>
      <source>The camera does not answer and may be asleep. Turn off its automatic power-off.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν απαντά· κοιμάται; Απενεργοποιήστε την αυτόματη διακοπή της.</translation>
    </message>
    <message>
      <source>The camera remains busy; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα παραμένει απασχολημένη· κλείστε την και ανοίξτε την.</translation>
    </message>
    <message>
      <source>The connection to the camera failed; check its cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σύνδεση με την κάμερα διακόπηκε· ελέγξτε το καλώδιό της.</translation>
    </message>
    <message>
      <source>Another program uses the camera, often the desktop&apos;s file manager; &apos;ostraka devices&apos; names it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα κρατά την κάμερα, συχνά η διαχείριση αρχείων· το 'ostraka devices' το ονομάζει.</translation>
    </message>
    <message>
      <source>The camera cannot be opened; check this user&apos;s permissions with &apos;ostraka devices&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν ανοίγει· επιτρέπεται σε αυτόν τον χρήστη; Δείτε 'ostraka devices'.</translation>
    </message>
    <message>
      <source>The camera sent no photograph; check that it is focused and set to manual.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ήρθε φωτογραφία από την κάμερα· είναι εστιασμένη και σε χειροκίνητη λειτουργία;</translation>
    </message>
    <message>
      <source>The camera does not stop sending photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν σταματά να παραδίδει φωτογραφίες.</translation>
    </message>
    <message>
      <source>This camera has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η κάμερα δεν δείχνει ζωντανή εικόνα.</translation>
    </message>
    <message>
      <source>The turntable does not reach its angle; check that nothing blocks it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν φτάνει στη γωνία του· είναι μπλοκαρισμένο;</translation>
    </message>
    <message>
      <source>The turntable was paused with its own button.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι σταμάτησε από το δικό του κουμπί.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η θέση του τραπεζιού δεν είναι γνωστή: μηδενίστε ή ευθυγραμμίστε το.</translation>
    </message>
    <message>
      <source>The turntable does not answer on the network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν απαντά στο δίκτυο.</translation>
    </message>
    <message>
      <source>The controller restarted; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής επανεκκίνησε· η θέση του τραπεζιού δεν είναι γνωστή.</translation>
    </message>
    <message>
      <source>A reply from the turntable was lost, and it cannot report its position: home it or align it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χάθηκε μια απάντηση του τραπεζιού και δεν μπορεί να πει πού βρίσκεται: μηδενίστε ή ευθυγραμμίστε το.</translation>
    </message>
    <message>
      <source>The turntable does not answer like a GRBL controller; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι δεν απαντά σαν ελεγκτής GRBL: είναι ανοιχτό και αυτού του τύπου;</translation>
    </message>
    <message>
      <source>The turntable does not answer like a ComXim; check that it is switched on and of this type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι δεν απαντά σαν ComXim: είναι ανοιχτό και αυτού του τύπου;</translation>
    </message>
    <message>
      <source>USB does not work on this computer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το USB δεν λειτουργεί σε αυτόν τον υπολογιστή.</translation>
    </message>
    <message>
      <source>The disk is full; free some space and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος είναι γεμάτος· ελευθερώστε χώρο και ξεκινήστε ξανά το ίδιο.</translation>
    </message>
    <message>
      <source>The disk is full; free some space, then try again. No data was lost.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος είναι γεμάτος· κάντε χώρο και δοκιμάστε ξανά. Τίποτα δεν χάθηκε.</translation>
    </message>
    <message>
      <source>Another program is using the catalogue; close it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα κρατά απασχολημένο τον κατάλογο· κλείστε το και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>Another program is repairing or using the catalogue; this one waits up to 10 seconds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα επιδιορθώνει ή χρησιμοποιεί τον κατάλογο· αυτό περιμένει έως 10 δευτερόλεπτα.</translation>
    </message>
    <message>
      <source>The image file is truncated; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα είναι κομμένη πριν από το τέλος της· αντιγράψτε την ξανά από την κάμερα.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a kind of context; use layer, cut, fill, structure, surface or unstratified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» δεν είναι είδος πλαισίου· μπορεί να είναι layer, cut, fill, structure, surface ή unstratified.</translation>
    </message>
    <message>
      <source>New sites and trenches: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Θέσεις και τομές που δεν υπήρχαν: %1· ελέγξτε ότι καμία δεν είναι λάθος γραφής.</translation>
    </message>
    <message>
      <source>The results of this batch no longer exist; reprocess it, then decide.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αποτελέσματα αυτής της παρτίδας δεν υπάρχουν πια· επανεπεξεργαστείτε την και μετά αποφασίστε.</translation>
    </message>
    <message>
      <source>Camera %1: its photographs come from different cameras (%2); give each camera its own name, because photographs with the same camera name share one lens calibration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: οι φωτογραφίες της προέρχονται από διαφορετικές κάμερες (%2)· δώστε σε κάθε κάμερα δικό της όνομα, γιατί οι φωτογραφίες με το ίδιο όνομα κάμερας μοιράζονται μία βαθμονόμηση φακού.</translation>
    </message>
    <message>
      <source>Camera %1: its focal length varies between photographs (%2); all share one lens calibration, so fix the zoom and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: η εστιακή της απόσταση δεν είναι ίδια σε όλες τις φωτογραφίες (%2)· όλες μοιράζονται μία βαθμονόμηση φακού, οπότε σταθεροποιήστε το ζουμ και φωτογραφίστε ξανά.</translation>
    </message>
    <message>
      <source>Camera %1: its aperture varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: το διάφραγμά της δεν είναι ίδιο σε όλες τις φωτογραφίες (%2)· ρυθμίστε την κάμερα στο χειροκίνητο: οι άνισες φωτογραφίες κάνουν τις μάσκες και τα χρώματα λιγότερο σίγουρα.</translation>
    </message>
    <message>
      <source>Camera %1: its exposure time varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: ο χρόνος έκθεσής της δεν είναι ίδιος σε όλες τις φωτογραφίες (%2)· ρυθμίστε την κάμερα στο χειροκίνητο: οι άνισες φωτογραφίες κάνουν τις μάσκες και τα χρώματα λιγότερο σίγουρα.</translation>
    </message>
    <message>
      <source>Camera %1: its sensitivity varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: η ευαισθησία της δεν είναι ίδια σε όλες τις φωτογραφίες (%2)· ρυθμίστε την κάμερα στο χειροκίνητο: οι άνισες φωτογραφίες κάνουν τις μάσκες και τα χρώματα λιγότερο σίγουρα.</translation>
    </message>
    <message>
      <source>Camera %1: its white balance varies between photographs (%2); set the camera to manual, because uneven photographs make masks and colours less reliable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: η ισορροπία λευκού της δεν είναι ίδια σε όλες τις φωτογραφίες (%2)· ρυθμίστε την κάμερα στο χειροκίνητο: οι άνισες φωτογραφίες κάνουν τις μάσκες και τα χρώματα λιγότερο σίγουρα.</translation>
    </message>
    <message>
      <source>No camera model fits the calibration pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία κάμερα δεν εξηγεί τις εικόνες βαθμονόμησης.</translation>
    </message>
    <message>
      <source>No photograph of this camera shows the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία φωτογραφία αυτής της κάμερας δεν δείχνει τους δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>No batch folder was given.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε φάκελος παρτίδας.</translation>
    </message>
    <message>
      <source>The angle is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γωνία δεν είναι αριθμός.</translation>
    </message>
    <message>
      <source>This program is not installed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το πρόγραμμα δεν είναι εγκατεστημένο.</translation>
    </message>
    <message>
      <source>The photographs show no common object; check the cameras, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε σώμα στο οποίο συμφωνούν οι φωτογραφίες· ελέγξτε τις κάμερες ή δώστε μάσκες.</translation>
    </message>
    <message>
      <source>A visual hull needs at least 3 photographs; photograph the object from more directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα περίβλημα χρειάζεται τουλάχιστον 3 φωτογραφίες· φωτογραφίστε το αντικείμενο από περισσότερες κατευθύνσεις.</translation>
    </message>
    <message>
      <source>The cameras do not view a common area; check their poses.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι κάμερες δεν κοιτούν σε κοινό σημείο· ελέγξτε τις θέσεις τους.</translation>
    </message>
    <message>
      <source>The network needs an 8-bit colour photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το δίκτυο χρειάζεται έγχρωμη φωτογραφία των 8 bit.</translation>
    </message>
    <message>
      <source>The drawing needs a scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε κλίμακα για το σχέδιο.</translation>
    </message>
    <message>
      <source>The preview was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια προεπισκόπηση αναιρείται.</translation>
    </message>
    <message>
      <source>Restoring a project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα έργο επαναφέρεται σε νέο ή κενό φάκελο· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>Not an archive of a whole project; import it as an export instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό δεν είναι αρχείο ολόκληρου έργου· εισαγάγετέ το ως εξαγωγή.</translation>
    </message>
    <message>
      <source>This is a project already, not an archive of one; open it as it is.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι ήδη έργο, όχι αρχείο έργου· ανοίξτε το όπως είναι.</translation>
    </message>
    <message>
      <source>This is an archive of a whole project, not an export; restore it (ostraka catalogue restore), then merge the restored project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι αρχείο ολόκληρου έργου, όχι εξαγωγή· επαναφέρετέ το (ostraka catalogue restore) και μετά συγχωνεύστε το έργο.</translation>
    </message>
    <message>
      <source>The file or folder cannot be written (%1); choose another location, or check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν γίνεται εγγραφή εδώ (%1)· επιλέξτε άλλη θέση ή ελέγξτε τα δικαιώματά της.</translation>
    </message>
    <message>
      <source>There is no such file; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει τέτοιο αρχείο· ελέγξτε το όνομά του.</translation>
    </message>
    <message>
      <source>The file cannot be opened (%1); check its permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο δεν ανοίγει (%1)· ελέγξτε τα δικαιώματά του.</translation>
    </message>
    <message>
      <source>The file is larger than the limit of %1 bytes; check that it is the right one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο είναι μεγαλύτερο από τα %1 byte που διαβάζονται εδώ· είναι το σωστό;</translation>
    </message>
    <message>
      <source>The file cannot be read (%1); copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο δεν διαβάζεται (%1)· αντιγράψτε το ξανά.</translation>
    </message>
    <message>
      <source>The JSON text is larger than 64 MiB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το κείμενο JSON είναι μεγαλύτερο από 64 MiB.</translation>
    </message>
    <message>
      <source>The JSON is nested more than 64 levels deep.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το JSON έχει πάνω από 64 επίπεδα εμφώλευσης.</translation>
    </message>
    <message>
      <source>Not valid JSON (line %1); correct that line, or copy the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι έγκυρο JSON (γραμμή %1)· διορθώστε το εκεί ή αντιγράψτε ξανά το αρχείο.</translation>
    </message>
    <message>
      <source>The JSON contains a number that is too large; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το JSON περιέχει έναν υπερβολικά μεγάλο αριθμό· διορθώστε τον.</translation>
    </message>
    <message>
      <source>A transform must be a 4x4 matrix.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας μετασχηματισμός πρέπει να είναι πίνακας 4x4.</translation>
    </message>
    <message>
      <source>A transform contains a value that is not a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας μετασχηματισμός περιέχει κάτι που δεν είναι αριθμός.</translation>
    </message>
    <message>
      <source>A transform is not rigid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας μετασχηματισμός δεν είναι άκαμπτος.</translation>
    </message>
    <message>
      <source>A transform moves by more than %1 mm; check that its last column is in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας μετασχηματισμός μετακινεί περισσότερο από %1 mm· ελέγξτε ότι η τελευταία του στήλη είναι σε mm.</translation>
    </message>
    <message>
      <source>There is no such folder; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει τέτοιος φάκελος· δώστε τον φάκελο μιας παρτίδας.</translation>
    </message>
    <message>
      <source>The front side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπει η μπροστινή όψη· βάλτε τις φωτογραφίες της στον φάκελο '%1'.</translation>
    </message>
    <message>
      <source>The back side is missing; put its photographs into the folder '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπει η πίσω όψη· βάλτε τις φωτογραφίες της στον φάκελο '%1'.</translation>
    </message>
    <message>
      <source>Not a batch folder: it has neither the folders &apos;front&apos; and &apos;back&apos; nor &apos;top_images&apos; and &apos;bottom_images&apos;; choose a batch folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι παρτίδα: δεν έχει ούτε τους φακέλους 'front' και 'back' ούτε τους 'top_images' και 'bottom_images'· δώστε τον φάκελο μιας παρτίδας.</translation>
    </message>
    <message>
      <source>The file name does not match the form %1; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα δεν έχει τη μορφή %1· αυτή η φωτογραφία παραλείπεται.</translation>
    </message>
    <message>
      <source>Another photograph has the same camera and position; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια άλλη φωτογραφία έχει την ίδια κάμερα και στάση· αυτή παραλείπεται.</translation>
    </message>
    <message>
      <source>This photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία παραλείπεται.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1 and %2 more. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπουν φωτογραφίες εδώ: %1 και %2 ακόμη· ό,τι βλέπουν μόνο αυτές θα συμπληρωθεί, γι’ αυτό τραβήξτε τις ξανά αν έχουν σημασία.</translation>
    </message>
    <message>
      <source>Photographs are missing: %1. Surfaces that only they show are filled in; retake them if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπουν φωτογραφίες εδώ: %1· ό,τι βλέπουν μόνο αυτές θα συμπληρωθεί, γι’ αυτό τραβήξτε τις ξανά αν έχουν σημασία.</translation>
    </message>
    <message>
      <source>This file name follows the naming of rig photographs, but most others do not; this photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα είναι φωτογραφίας από διάταξη, αλλά τα περισσότερα άλλα δεν είναι· αυτή η φωτογραφία παραλείπεται.</translation>
    </message>
    <message>
      <source>Another photograph has the same name; this one is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια άλλη φωτογραφία έχει το ίδιο όνομα· αυτή παραλείπεται.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες κάτω από %1 megapixel παραλείπονται (%2 και %3 ακόμη)· αντιγράψτε τα πρωτότυπα από την κάμερα αντί για μικρογραφίες.</translation>
    </message>
    <message>
      <source>Photographs of less than %1 megapixels are left out (%2); copy the originals from the camera instead of thumbnails.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες κάτω από %1 megapixel παραλείπονται (%2)· αντιγράψτε τα πρωτότυπα από την κάμερα αντί για μικρογραφίες.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs are used: the most detailed ones, spread over the series. More would take longer and add little.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιούνται %1 από τις %2 φωτογραφίες: οι πιο λεπτομερείς, κατανεμημένες στη σειρά. Περισσότερες αργούν και προσθέτουν λίγα.</translation>
    </message>
    <message>
      <source>This folder contains no photographs; put the photographs of one side into it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε αυτόν τον φάκελο δεν υπάρχουν φωτογραφίες· βάλτε εκεί τις φωτογραφίες μιας όψης.</translation>
    </message>
    <message>
      <source>This folder contains neither photographs nor the folders &apos;front&apos; and &apos;back&apos; of a batch; choose a folder with photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε αυτόν τον φάκελο δεν υπάρχουν ούτε φωτογραφίες ούτε οι φάκελοι «front» και «back» μιας παρτίδας· δώστε έναν φάκελο με φωτογραφίες.</translation>
    </message>
    <message>
      <source>There is no such folder; choose one with the photographs of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει τέτοιος φάκελος· δώστε έναν με τις φωτογραφίες μιας όψης.</translation>
    </message>
    <message>
      <source>The same folder is given for the front and the back; choose the folder of each side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος δόθηκε για την μπροστινή και την πίσω όψη· δώστε τον φάκελο κάθε όψης.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμες φωτογραφίες της μπροστινής όψης: %1· χρειάζονται τουλάχιστον %2. Τραβήξτε περισσότερες από όλες τις κατευθύνσεις.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Take more from all directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμες φωτογραφίες της πίσω όψης: %1· χρειάζονται τουλάχιστον %2. Τραβήξτε περισσότερες από όλες τις κατευθύνσεις.</translation>
    </message>
    <message>
      <source>The HEIC image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα HEIC είναι κατεστραμμένη· αντιγράψτε την ξανά.</translation>
    </message>
    <message>
      <source>The RAW image is damaged, or its camera is not supported; copy it again, or export it as TIFF.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα RAW είναι κατεστραμμένη ή από άγνωστη κάμερα· αντιγράψτε την ξανά ή εξαγάγετέ την ως TIFF.</translation>
    </message>
    <message>
      <source>The side of a marker must be between 0.5 and 1000 mm; measure a black square on the paper.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πλευρά ενός δείκτη πρέπει να είναι μεταξύ 0,5 και 1000 mm· μετρήστε ένα μαύρο τετράγωνο στο χαρτί.</translation>
    </message>
    <message>
      <source>No sheet with at least %1 markers of OpenCV&apos;s dictionaries was found in these %2 photographs; take photographs that show more of the sheet, or specify its plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε αυτές τις %2 φωτογραφίες δεν διαβάζεται φύλλο με τουλάχιστον %1 δείκτες των λεξικών της OpenCV· τραβήξτε φωτογραφίες που δείχνουν περισσότερο από αυτό ή δώστε το plate.json του.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 with sides of %3 mm were found in the photographs (%4 px) and are used instead. Measure the distance between two markers that are far apart and compare it with plate.json in the output folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα plate.json δεν περιγράφει το φύλλο: %1 δείκτες του %2 με πλευρές %3 mm βρέθηκαν στις φωτογραφίες (%4 px) και λαμβάνονται ως αυτό. Μετρήστε την απόσταση δύο απομακρυσμένων δεικτών και συγκρίνετέ την με το plate.json στον φάκελο εξόδου.</translation>
    </message>
    <message>
      <source>No plate.json describes the sheet: %1 markers of %2 were found in the photographs (%3 px), but their size is unknown, so the result has no scale. Measure the side of a marker&apos;s black square and give it with --marker-mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα plate.json δεν περιγράφει το φύλλο: στις φωτογραφίες βρέθηκαν %1 δείκτες του %2 (%3 px) και το μέγεθός τους δεν είναι γνωστό, οπότε το αποτέλεσμα δεν έχει κλίμακα. Μετρήστε την πλευρά του μαύρου τετραγώνου ενός δείκτη και δώστε την με --marker-mm.</translation>
    </message>
    <message>
      <source>This mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η μάσκα δεν χρησιμοποιείται.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size; the mask is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μάσκα δεν έχει το μέγεθος της φωτογραφίας της· δεν χρησιμοποιείται.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμες φωτογραφίες της μπροστινής όψης: %1· χρειάζονται τουλάχιστον %2. Προσθέστε φωτογραφίες με όνομα %3.</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Add photographs named %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμες φωτογραφίες της πίσω όψης: %1· χρειάζονται τουλάχιστον %2. Προσθέστε φωτογραφίες με όνομα %3.</translation>
    </message>
    <message>
      <source>The file name is neither cam&lt;C&gt;_cal&lt;NN&gt;.jpg nor empty_cam&lt;C&gt;.jpg; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα δεν είναι ούτε cam&lt;C&gt;_cal&lt;NN&gt;.jpg ούτε empty_cam&lt;C&gt;.jpg· αυτή η εικόνα παραλείπεται.</translation>
    </message>
    <message>
      <source>This picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η εικόνα παραλείπεται.</translation>
    </message>
    <message>
      <source>The image has %1 x %2 pixels, but the photographs from its camera have %3 x %4; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα έχει %1 x %2 εικονοστοιχεία, οι φωτογραφίες της κάμεράς της %3 x %4· αυτή η εικόνα παραλείπεται.</translation>
    </message>
    <message>
      <source>The image header states a size of %1 x %2 pixels, which cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα δηλώνει μέγεθος %1 x %2 εικονοστοιχεία, που δεν μπορεί να χρησιμοποιηθεί.</translation>
    </message>
    <message>
      <source>The network&apos;s file is damaged; copy it again, or export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο του δικτύου είναι κατεστραμμένο· αντιγράψτε το ή εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>A layer of the network has &apos;%1&apos; %2, but only %3 to %4 can be used; use another network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα επίπεδο του δικτύου έχει «%1» %2, αλλά μόνο τιμές από %3 έως %4 μπορούν να χρησιμοποιηθούν· χρησιμοποιήστε άλλο δίκτυο.</translation>
    </message>
    <message>
      <source>The network&apos;s weights are in another file; export it as one file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα βάρη του δικτύου βρίσκονται σε άλλο αρχείο· εξαγάγετέ το ως ένα αρχείο.</translation>
    </message>
    <message>
      <source>The network takes %1 GB of memory for one photograph, but at most %2 GB can be used; use a smaller network, or one with a smaller input.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το δίκτυο χρειάζεται %1 GB μνήμης για μία φωτογραφία, αλλά μπορούν να χρησιμοποιηθούν το πολύ %2 GB· χρησιμοποιήστε μικρότερο δίκτυο ή ένα με μικρότερη είσοδο.</translation>
    </message>
    <message>
      <source>The JPEG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα JPEG είναι κατεστραμμένη· αντιγράψτε την ξανά.</translation>
    </message>
    <message>
      <source>The JPEG file contains no image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το JPEG δεν περιέχει εικόνα.</translation>
    </message>
    <message>
      <source>The PNG image is damaged; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα PNG είναι κατεστραμμένη· αντιγράψτε την ξανά.</translation>
    </message>
    <message>
      <source>The TIFF file does not state the image&apos;s size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα TIFF δεν δηλώνει μέγεθος.</translation>
    </message>
    <message>
      <source>The file is empty; copy it from the camera again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο είναι άδειο· αντιγράψτε το ξανά από την κάμερα.</translation>
    </message>
    <message>
      <source>Not a JPEG, PNG, TIFF, HEIC or RAW image.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι εικόνα JPEG, PNG, TIFF, HEIC ή RAW.</translation>
    </message>
    <message>
      <source>The known lengths cannot be used: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα γνωστά μήκη δεν μπορούν να χρησιμοποιηθούν: %1.</translation>
    </message>
    <message>
      <source>'side' must be 'front' or 'back'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το 'side' πρέπει να είναι 'front' ή 'back'</translation>
    </message>
    <message>
      <source>'ends' must be two lists of marks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το 'ends' πρέπει να είναι δύο λίστες σημαδιών</translation>
    </message>
    <message>
      <source>each end must be marked on at least two photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάθε άκρο πρέπει να σημειωθεί σε τουλάχιστον δύο φωτογραφίες</translation>
    </message>
    <message>
      <source>their unit must be mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η μονάδα τους πρέπει να είναι mm</translation>
    </message>
    <message>
      <source>each needs 'side', 'length' and 'ends' with 'file' and 'pixel'</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>καθένα χρειάζεται 'side', 'length' και 'ends' με 'file' και 'pixel'</translation>
    </message>
    <message>
      <source>The image cannot be decoded; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικόνα δεν αποκωδικοποιείται· αντιγράψτε την ξανά.</translation>
    </message>
    <message>
      <source>The plate&apos;s unit must be mm; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μονάδα του δίσκου πρέπει να είναι mm· δημιουργήστε ξανά το αρχείο του δίσκου.</translation>
    </message>
    <message>
      <source>The plate file lists more than 1024 markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος ονομάζει πάνω από 1024 δείκτες.</translation>
    </message>
    <message>
      <source>The plate file needs &apos;dictionary&apos; and &apos;markers&apos;, each with an id and four corners of three numbers; &apos;diameter&apos;, if given, is a number in mm, &apos;sheet&apos; the paper&apos;s width and height.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο του δίσκου χρειάζεται 'dictionary' και 'markers' με ένα id και τέσσερις γωνίες τριών αριθμών η καθεμία· το 'diameter', αν δίνεται, είναι αριθμός σε mm, το 'sheet' το πλάτος και το ύψος του χαρτιού.</translation>
    </message>
    <message>
      <source>The plate file lists no markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος δεν ονομάζει κανέναν δείκτη.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate has no valid corners.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δείκτης %1 του δίσκου δεν έχει έγκυρες γωνίες.</translation>
    </message>
    <message>
      <source>Marker %1 occurs twice on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δείκτης %1 υπάρχει δύο φορές στον δίσκο.</translation>
    </message>
    <message>
      <source>The board needs 'dictionary', 'squares_x', 'squares_y', 'square_mm' and 'marker_mm'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας βαθμονόμησης χρειάζεται 'dictionary', 'squares_x', 'squares_y', 'square_mm' και 'marker_mm'.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another batch name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη αρχείο με αυτό το όνομα και δεν αντικαθίσταται· δώστε άλλη παρτίδα.</translation>
    </message>
    <message>
      <source>This batch started on another plate; continue with that plate or start a new batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα άρχισε σε άλλον δίσκο: συνεχίστε με εκείνον ή αρχίστε άλλη παρτίδα.</translation>
    </message>
    <message>
      <source>This batch started with another setup (cameras: %1, positions: %2; now: %3 and %4); choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα ξεκίνησε με άλλη διάταξη (κάμερες: %1, στάσεις: %2· τώρα: %3 και %4)· επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>The photograph has changed since it was taken; restore the original or choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία άλλαξε μετά τη λήψη της· βάλτε πίσω την αρχική ή δώστε άλλον φάκελο για την παρτίδα.</translation>
    </message>
    <message>
      <source>This photograph does not belong to this batch; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία δεν τραβήχτηκε εδώ· δώστε άλλον φάκελο για την παρτίδα.</translation>
    </message>
    <message>
      <source>Camera %1 delivers raw files only; set its image format to JPEG, or to both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 δίνει μόνο αρχεία raw· ρυθμίστε τη μορφή εικόνας της σε JPEG ή και στα δύο.</translation>
    </message>
    <message>
      <source>%1 is %2, but the rig specifies %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το %1 είναι %2, η διάταξη λέει %3</translation>
    </message>
    <message>
      <source>%1 is %2, but the first photograph used %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το %1 είναι %2, στην πρώτη φωτογραφία ήταν %3</translation>
    </message>
    <message>
      <source>The turntable did not reach its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν έφτασε στο μηδέν του.</translation>
    </message>
    <message>
      <source>The turntable does not report its position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν αναφέρει τη στάση του.</translation>
    </message>
    <message>
      <source>The turntable rejected a command (error %1): wrong turntable type or bad cable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι απέρριψε μια εντολή (σφάλμα %1): λάθος τύπος τραπεζιού ή κακό καλώδιο.</translation>
    </message>
    <message>
      <source>The turntable&apos;s speed must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ταχύτητα του τραπεζιού πρέπει να είναι μεγαλύτερη από 0.</translation>
    </message>
    <message>
      <source>The connection to the turntable failed (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σύνδεση με το περιστρεφόμενο τραπέζι διακόπηκε (%1).</translation>
    </message>
    <message>
      <source>it is not open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν είναι ανοιχτή</translation>
    </message>
    <message>
      <source>it accepts no more data</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν δέχεται άλλα byte</translation>
    </message>
    <message>
      <source>it was closed at the other end</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>έκλεισε από την άλλη άκρη</translation>
    </message>
    <message>
      <source>You have no permission to use this serial port; install Ostraka&apos;s udev rules or join the group dialout, then log in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν επιτρέπεται η χρήση αυτής της σειριακής θύρας· εγκαταστήστε τους κανόνες udev του Ostraka ή μπείτε στην ομάδα dialout και συνδεθείτε ξανά.</translation>
    </message>
    <message>
      <source>The serial port does not exist; check that the turntable is plugged in and switched on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σειριακή θύρα δεν υπάρχει· είναι το περιστρεφόμενο τραπέζι συνδεδεμένο και ανοιχτό;</translation>
    </message>
    <message>
      <source>Not a serial port.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι σειριακή θύρα.</translation>
    </message>
    <message>
      <source>The serial port does not accept its settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σειριακή θύρα δεν δέχεται τις ρυθμίσεις της.</translation>
    </message>
    <message>
      <source>The turntable&apos;s address is unknown on this network.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διεύθυνση του περιστρεφόμενου τραπεζιού δεν είναι γνωστή σε αυτό το δίκτυο.</translation>
    </message>
    <message>
      <source>A serial port does not support %1 baud; common rates are 9600 and 115200.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια σειριακή θύρα δεν λειτουργεί στα %1 baud· συνηθισμένα είναι τα 9600 και 115200.</translation>
    </message>
    <message>
      <source>A network address looks like 192.168.0.7:23.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια διεύθυνση δικτύου γράφεται όπως 192.168.0.7:23.</translation>
    </message>
    <message>
      <source>The desktop does not release the camera: it is still in use by %1; close its file window and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επιφάνεια εργασίας δεν αφήνει την κάμερα: την κρατά ακόμη το %1· κλείστε το παράθυρο των αρχείων της και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>A watched folder has no setting %1; set it on the camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας παρακολουθούμενος φάκελος δεν έχει τη ρύθμιση %1· ρυθμίστε τη στην κάμερα.</translation>
    </message>
    <message>
      <source>A watched folder has no live view.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας παρακολουθούμενος φάκελος δεν δείχνει ζωντανή εικόνα.</translation>
    </message>
    <message>
      <source>No new photograph arrived within %1 seconds; check that the camera&apos;s software writes into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ήρθε νέα φωτογραφία σε %1 δευτερόλεπτα· γράφει το πρόγραμμα της κάμερας σε αυτόν τον φάκελο;</translation>
    </message>
    <message>
      <source>The watched folder cannot be read (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο παρακολουθούμενος φάκελος δεν διαβάζεται (%1).</translation>
    </message>
    <message>
      <source>Two photographs arrived for one shot, %1 and %2; use one folder per camera and one photograph per position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ήρθαν δύο φωτογραφίες για μία λήψη, %1 και %2· μία κάμερα ανά φάκελο, μία φωτογραφία ανά στάση.</translation>
    </message>
    <message>
      <source>The camera with this serial number is not plugged in; found: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα με αυτόν τον σειριακό αριθμό δεν είναι συνδεδεμένη· υπάρχει: %1.</translation>
    </message>
    <message>
      <source>The camera does not offer %1 for %2; it is set to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν προσφέρει %1 για το %2· βρίσκεται στο %3.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3; check its mode dial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα κρατά το %1 στο %2 αντί για %3· κοιτάξτε τον επιλογέα λειτουργίας της.</translation>
    </message>
    <message>
      <source>The camera has no setting %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν έχει τη ρύθμιση %1.</translation>
    </message>
    <message>
      <source>The camera reports: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα αναφέρει: %1.</translation>
    </message>
    <message>
      <source>The turntable has no zero switch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι δεν έχει διακόπτη μηδενισμού.</translation>
    </message>
    <message>
      <source>It did not answer while homing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν απάντησε κατά τον μηδενισμό.</translation>
    </message>
    <message>
      <source>It did not unlock.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ξεκλείδωσε.</translation>
    </message>
    <message>
      <source>It did not answer the shutter command.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν απάντησε όταν έπρεπε να γίνει η λήψη.</translation>
    </message>
    <message>
      <source>The turntable does not answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν απαντά.</translation>
    </message>
    <message>
      <source>The turntable does not stop moving.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν ηρεμεί.</translation>
    </message>
    <message>
      <source>The turntable does not accept its zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν δέχεται το μηδέν του.</translation>
    </message>
    <message>
      <source>The controller reset its count; the turntable&apos;s position is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής μετρά από την αρχή· η θέση του τραπεζιού δεν είναι γνωστή.</translation>
    </message>
    <message>
      <source>The turntable does not move.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν κινείται.</translation>
    </message>
    <message>
      <source>The turntable did not arrive in time; it was stopped.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν έφτασε εγκαίρως· σταμάτησε.</translation>
    </message>
    <message>
      <source>The shutter output must be M8, M7, M3 or M62 Pn.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η έξοδος του κλείστρου πρέπει να είναι M8, M7, M3 ή M62 Pn.</translation>
    </message>
    <message>
      <source>The turntable was stopped while moving and lost its position: align the zero mark (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι σταμάτησε εν κινήσει και η θέση του χάθηκε: ευθυγραμμίστε το σημάδι του μηδενός (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller reports a turn beyond its travel: switch $20 off (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής του τραπεζιού λέει ότι η στροφή ξεπερνά τη διαδρομή του: απενεργοποιήστε το $20 (ALARM:%1).</translation>
    </message>
    <message>
      <source>Homing failed: check the zero switch and its cable (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο μηδενισμός απέτυχε: ελέγξτε τον διακόπτη μηδενισμού και το καλώδιό του (ALARM:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller raised an alarm (ALARM:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής του τραπεζιού έδωσε συναγερμό (ALARM:%1).</translation>
    </message>
    <message>
      <source>The controller does not understand the command: wrong controller type or bad cable (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής δεν καταλαβαίνει την εντολή: λάθος τύπος ελεγκτή ή κακό καλώδιο (error:%1).</translation>
    </message>
    <message>
      <source>The turntable has no zero switch (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι δεν έχει διακόπτη μηδενισμού (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is still moving (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι κινείται ακόμη (error:%1).</translation>
    </message>
    <message>
      <source>The turntable is locked: home it or unlock it (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τραπέζι είναι κλειδωμένο: μηδενίστε ή ξεκλειδώστε το (error:%1).</translation>
    </message>
    <message>
      <source>The turntable&apos;s controller rejected a command (error:%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο ελεγκτής του τραπεζιού απέρριψε μια εντολή (error:%1).</translation>
    </message>
    <message>
      <source>Turn the turntable counter-clockwise to %1 degrees, then take your hand away.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στρέψτε το τραπέζι αριστερόστροφα στις %1 μοίρες και τραβήξτε το χέρι σας.</translation>
    </message>
    <message>
      <source>Not an Ostraka photograph list; choose another folder for the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι κατάλογος φωτογραφιών του Ostraka· δώστε άλλον φάκελο για την παρτίδα.</translation>
    </message>
    <message>
      <source>The turntable driver %1 is unknown; available: grbl, comxim1, comxim2, text, hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα οδήγησης %1 του περιστρεφόμενου τραπεζιού δεν είναι γνωστό· υπάρχουν: grbl, comxim1, comxim2, text, hand.</translation>
    </message>
    <message>
      <source>The camera driver %1 is unknown; available: folder, gphoto2, uvc.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα οδήγησης κάμερας %1 δεν είναι γνωστό· υπάρχουν: folder, gphoto2, uvc.</translation>
    </message>
    <message>
      <source>The rig names no devices; &apos;ostraka devices&apos; lists what is plugged in and how to enter it in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη δεν ονομάζει συσκευές· το 'ostraka devices' λέει τι είναι συνδεδεμένο και πώς γράφεται εκεί.</translation>
    </message>
    <message>
      <source>The rig names no camera.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη δεν ονομάζει καμία κάμερα.</translation>
    </message>
    <message>
      <source>settle_s and speed_deg_s must be positive.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα settle_s και speed_deg_s πρέπει να είναι θετικά.</translation>
    </message>
    <message>
      <source>The section &apos;devices&apos; cannot be read; compare it with docs/devices.md.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μέρος 'devices' δεν διαβάζεται· συγκρίνετέ το με το docs/devices.md.</translation>
    </message>
    <message>
      <source>The number of positions must be between 3 and 99.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός των στάσεων πρέπει να είναι μεταξύ 3 και 99.</translation>
    </message>
    <message>
      <source>The rig has no camera or no turntable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη δεν έχει κάμερα ή δεν έχει περιστρεφόμενο τραπέζι.</translation>
    </message>
    <message>
      <source>There is no shot %1 to retake: this side has positions 1 to %2 and cameras A to %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει λήψη %1 για επανάληψη: αυτή η όψη έχει τις στάσεις 1 έως %2 και τις κάμερες A έως %3.</translation>
    </message>
    <message>
      <source>Camera %1 of this batch was %2, but the connected one is %3; continue with the original cameras or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 αυτής της παρτίδας ήταν η %2, αυτή εδώ είναι η %3· συνεχίστε με τις κάμερες που την άρχισαν ή δώστε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>The turntable&apos;s position is unknown: turn its zero mark to the front and set zero.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η θέση του τραπεζιού δεν είναι γνωστή: στρέψτε το σημάδι του μηδενός μπροστά και ορίστε το μηδέν.</translation>
    </message>
    <message>
      <source>Camera %1, position %2 failed %3 times: %4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1, στάση %2: απέτυχε %3 φορές: %4.</translation>
    </message>
    <message>
      <source>Camera %1 delivers only earlier or broken photographs; switch it off and on.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 παραδίδει μόνο παλιότερες ή κατεστραμμένες φωτογραφίες· κλείστε την και ανοίξτε την.</translation>
    </message>
    <message>
      <source>The turntable does not answer as a %1; check its type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν απαντά ως %1· μήπως είναι άλλο;</translation>
    </message>
    <message>
      <source>Marlin controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ελεγκτής Marlin</translation>
    </message>
    <message>
      <source>text controller</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ελεγκτής κειμένου</translation>
    </message>
    <message>
      <source>This turntable has no zero switch: align it by eye.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το τραπέζι δεν έχει διακόπτη μηδενισμού: ευθυγραμμίστε το με το μάτι.</translation>
    </message>
    <message>
      <source>The turntable rejects the command: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι αρνείται: %1.</translation>
    </message>
    <message>
      <source>The turntable is at %1 degrees instead of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι βρίσκεται στις %1 μοίρες αντί για %2.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;move&apos; must contain {target} or {by}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάλεκτος του περιστρεφόμενου τραπεζιού: το 'move' πρέπει να περιέχει {target} ή {by}.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;accepted&apos; must describe its answer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάλεκτος του περιστρεφόμενου τραπεζιού: το 'accepted' πρέπει να λέει πώς απαντά.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;query&apos; and &apos;position&apos; must be given together.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάλεκτος του περιστρεφόμενου τραπεζιού: τα 'query' και 'position' πάνε μαζί.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;reply_s&apos; must be greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάλεκτος του περιστρεφόμενου τραπεζιού: το 'reply_s' πρέπει να είναι μεγαλύτερο από 0.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;%1&apos; is not a regular expression.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάλεκτος του περιστρεφόμενου τραπεζιού: το '%1' δεν είναι κανονική έκφραση.</translation>
    </message>
    <message>
      <source>The turntable&apos;s dialect: &apos;position&apos; needs a group for the angle.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάλεκτος του περιστρεφόμενου τραπεζιού: το 'position' χρειάζεται μια ομάδα για τη γωνία.</translation>
    </message>
    <message>
      <source>The turntable&apos;s &apos;dialect&apos; must be &quot;marlin&quot; or an object with its commands.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το 'dialect' του περιστρεφόμενου τραπεζιού πρέπει να είναι "marlin" ή οι λέξεις του.</translation>
    </message>
    <message>
      <source>The turntable is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν είναι συνδεδεμένο.</translation>
    </message>
    <message>
      <source>The turntable&apos;s USB connection failed (%1); plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σύνδεση USB του περιστρεφόμενου τραπεζιού απέτυχε (%1)· συνδέστε το ξανά.</translation>
    </message>
    <message>
      <source>You have no permission to use this USB device; install packaging/udev/70-ostraka.rules and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν επιτρέπεται η χρήση αυτής της συσκευής USB· εγκαταστήστε το packaging/udev/70-ostraka.rules και συνδέστε την ξανά.</translation>
    </message>
    <message>
      <source>Another program uses the turntable; close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι χρησιμοποιείται από άλλο πρόγραμμα· κλείστε το.</translation>
    </message>
    <message>
      <source>The turntable cannot be opened (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι δεν ανοίγει (%1).</translation>
    </message>
    <message>
      <source>This USB device is not a serial controller (CDC-ACM).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η συσκευή USB δεν είναι σειριακός ελεγκτής (CDC-ACM).</translation>
    </message>
    <message>
      <source>The turntable with this serial number is not plugged in.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιστρεφόμενο τραπέζι με αυτόν τον σειριακό αριθμό δεν είναι συνδεδεμένο.</translation>
    </message>
    <message>
      <source>A USB turntable is named by vendor and product, for example usb:1209:0001.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα περιστρεφόμενο τραπέζι USB ονομάζεται με κατασκευαστή και προϊόν, όπως usb:1209:0001.</translation>
    </message>
    <message>
      <source>The video camera cannot be opened; check that it is plugged in and that no other program uses it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η βιντεοκάμερα δεν ανοίγει: είναι συνδεδεμένη, και δεν τη χρησιμοποιεί άλλο πρόγραμμα;</translation>
    </message>
    <message>
      <source>A video camera has exposure (0.1 ms), focus, white_balance (K) and gain, as numbers; not %1 %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια βιντεοκάμερα έχει exposure (0,1 ms), focus, white_balance (K) και gain, ως αριθμούς· όχι %1 %2.</translation>
    </message>
    <message>
      <source>The camera keeps %1 at %2 instead of %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα κρατά το %1 στο %2 αντί για %3.</translation>
    </message>
    <message>
      <source>The video camera no longer delivers pictures.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η βιντεοκάμερα δεν δίνει πια εικόνες.</translation>
    </message>
    <message>
      <source>The video camera took no picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η βιντεοκάμερα δεν τράβηξε εικόνα.</translation>
    </message>
    <message>
      <source>The video camera delivers pictures of %1x%2 pixels instead of the configured size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η βιντεοκάμερα δίνει εικόνες %1x%2 εικονοστοιχείων, όχι του μεγέθους που ορίστηκε.</translation>
    </message>
    <message>
      <source>Another program is writing decisions or masks of this batch, so nothing was saved; try again in a moment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα γράφει αποφάσεις ή μάσκες αυτής της παρτίδας, γι&apos; αυτό δεν αποθηκεύτηκε τίποτα· δοκιμάστε ξανά σε λίγο.</translation>
    </message>
    <message>
      <source>The part of Ostraka that video cameras need cannot be loaded; install Ostraka again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τμήμα του Ostraka που χρειάζονται οι βιντεοκάμερες δεν φορτώνεται· εγκαταστήστε ξανά το Ostraka.</translation>
    </message>
    <message>
      <source>The video camera must be named.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η βιντεοκάμερα πρέπει να ονομαστεί.</translation>
    </message>
    <message>
      <source>the file is truncated or not a picture</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το αρχείο είναι κομμένο ή δεν είναι εικόνα</translation>
    </message>
    <message>
      <source>the markers show an angle other than this position&apos;s</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>οι δείκτες δείχνουν άλλη γωνία από αυτήν της στάσης</translation>
    </message>
    <message>
      <source>the picture&apos;s size differs from that of the camera&apos;s other pictures</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η εικόνα έχει άλλο μέγεθος από τις άλλες της κάμερας</translation>
    </message>
    <message>
      <source>too few markers are visible to identify the position: check that nothing covers them and that the picture is sharp</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φαίνονται πολύ λίγοι δείκτες για να βρεθεί η στάση: υπάρχει κάτι μπροστά τους, είναι θολή;</translation>
    </message>
    <message>
      <source>the camera delivered an earlier photograph again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η κάμερα παρέδωσε ξανά μια παλιότερη φωτογραφία</translation>
    </message>
    <message>
      <source>too few markers of the plate are visible: check that nothing covers them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>φαίνονται πολύ λίγοι δείκτες του δίσκου: υπάρχει κάτι μπροστά τους;</translation>
    </message>
    <message>
      <source>the picture is blurred: check that the turntable is still and the focus is unchanged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>είναι θολή: κουνιόταν ακόμη το τραπέζι, άλλαξε η εστίαση;</translation>
    </message>
    <message>
      <source>the sherds are too dark: add light or increase the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τα όστρακα είναι πολύ σκοτεινά: δώστε περισσότερο φως ή μεγαλύτερη έκθεση</translation>
    </message>
    <message>
      <source>the sherds are overexposed: reduce the exposure time</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τα όστρακα είναι υπερεκτεθειμένα: μικρότερη έκθεση</translation>
    </message>
    <message>
      <source>a sherd is cut off by the picture's edge: move it or the camera</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το άκρο της εικόνας κόβει ένα όστρακο: μετακινήστε το ή την κάμερα</translation>
    </message>
    <message>
      <source>the camera&apos;s settings have changed: restore them</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>οι ρυθμίσεις της κάμερας άλλαξαν: επαναφέρετέ τες</translation>
    </message>
    <message>
      <source>%1: restore it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: επαναφέρετέ το</translation>
    </message>
    <message>
      <source>A plate holds 1 to 60 sherds; 0 means not counted.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας δίσκος χωρά 1 έως 60 όστρακα· 0 σημαίνει αμέτρητα.</translation>
    </message>
    <message>
      <source>The number of a batch is also the name of its folder; use letters and digits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός μιας παρτίδας είναι και το όνομα του φακέλου της· χρησιμοποιήστε γράμματα και ψηφία.</translation>
    </message>
    <message>
      <source>The uuid of a batch is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το uuid μιας παρτίδας δεν είναι σωστά γραμμένο.</translation>
    </message>
    <message>
      <source>The batch %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη παρτίδα %1.</translation>
    </message>
    <message>
      <source>This batch is not in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα δεν είναι στον κατάλογο.</translation>
    </message>
    <message>
      <source>The project&apos;s code must be 2 to 8 letters from A to Z or digits, for example ARM.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός του έργου πρέπει να έχει 2 έως 8 λατινικά κεφαλαία από A έως Z ή ψηφία, όπως ARM.</translation>
    </message>
    <message>
      <source>A vocabulary term must contain letters and no &apos;;&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας όρος λεξιλογίου πρέπει να έχει γράμματα και όχι ';'.</translation>
    </message>
    <message>
      <source>The term &apos;%1&apos; appears twice in the vocabulary.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο όρος '%1' υπάρχει δύο φορές στο λεξιλόγιο.</translation>
    </message>
    <message>
      <source>Sherds with the term '%1': %2; change those first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα με τον όρο «%1»: %2· αλλάξτε πρώτα αυτά.</translation>
    </message>
    <message>
      <source>a row of %1 refers to a missing row</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μια γραμμή του %1 δεν δείχνει πουθενά</translation>
    </message>
    <message>
      <source>the sherd tables are inconsistent</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>οι πίνακες των οστράκων δεν συμφωνούν μεταξύ τους</translation>
    </message>
    <message>
      <source>the search index is incomplete</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η αναζήτηση δεν γνωρίζει όλα τα όστρακα</translation>
    </message>
    <message>
      <source>The backup does not contain the saved data; try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αντίγραφο ασφαλείας δεν περιέχει όσα αποθηκεύτηκαν· δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>The catalogue cannot be opened; check that the folder exists and is writable.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κατάλογος δεν ανοίγει· ελέγξτε ότι ο φάκελος υπάρχει και επιτρέπει εγγραφή.</translation>
    </message>
    <message>
      <source>The catalogue cannot be written to; check the permissions of the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν γίνεται εγγραφή στον κατάλογο· ελέγξτε τα δικαιώματα του φακέλου.</translation>
    </message>
    <message>
      <source>The disk reports errors; check it, then reopen the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο σκληρός δίσκος δεν απαντά σωστά· ελέγξτε τον και ανοίξτε ξανά το έργο.</translation>
    </message>
    <message>
      <source>The catalogue rejects this operation (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κατάλογος δεν το δέχεται (%1).</translation>
    </message>
    <message>
      <source>The scan is not a front of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση δεν είναι μπροστινή όψη αυτής της παρτίδας.</translation>
    </message>
    <message>
      <source>The scan is not a back of this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση δεν είναι πίσω όψη αυτής της παρτίδας.</translation>
    </message>
    <message>
      <source>A pair needs a front and a back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα ζεύγος έχει μπροστινή και πίσω όψη.</translation>
    </message>
    <message>
      <source>The decision to undo is not in this batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση που θα ανακληθεί δεν είναι σε αυτή την παρτίδα.</translation>
    </message>
    <message>
      <source>A decision needs a front, a back or both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια απόφαση ονομάζει μπροστινή όψη, πίσω όψη ή και τις δύο.</translation>
    </message>
    <message>
      <source>The uuid of a decision is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το uuid μιας απόφασης δεν είναι σωστά γραμμένο.</translation>
    </message>
    <message>
      <source>This file is outside the project&apos;s folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο δεν βρίσκεται στον φάκελο του έργου.</translation>
    </message>
    <message>
      <source>This is a draft from reduced photographs; reprocess the batch for final measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι προσχέδιο από σμικρυμένες φωτογραφίες· επανεπεξεργαστείτε την παρτίδα για οριστικές μετρήσεις.</translation>
    </message>
    <message>
      <source>These results of &apos;ostraka process&apos; are incomplete; run it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι πλήρη αποτελέσματα του 'ostraka process'· εκτελέστε το ξανά.</translation>
    </message>
    <message>
      <source>Another program is entering results of this batch; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άλλο πρόγραμμα καταχωρίζει αποτελέσματα αυτής της παρτίδας· αυτό περιμένει να τελειώσει.</translation>
    </message>
    <message>
      <source>The pair table names the scan %1, which is missing; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας των ζευγών ονομάζει τη σάρωση %1, που δεν υπάρχει· εκτελέστε ξανά το 'ostraka process'.</translation>
    </message>
    <message>
      <source>This batch is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This photograph is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This scan is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η σάρωση δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This file is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This person is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το άτομο δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This site is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η θέση δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This trench is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η τομή δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This context is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το πλαίσιο δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>This bag is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η σακούλα δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>The filter has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το φίλτρο ανοίγει εισαγωγικά και δεν τα κλείνει.</translation>
    </message>
    <message>
      <source>This is only part of a sherd&apos;s label; scan its code again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι μόνο μέρος της ετικέτας ενός οστράκου· διαβάστε ξανά τον κωδικό της.</translation>
    </message>
    <message>
      <source>The filter is not valid text.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το φίλτρο δεν είναι αναγνώσιμο κείμενο.</translation>
    </message>
    <message>
      <source>There is no field '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει πεδίο '%1'.</translation>
    </message>
    <message>
      <source>Some of the changes remain because they could not be undone: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μερικές από τις αλλαγές μένουν, γιατί δεν αναιρέθηκαν: %1</translation>
    </message>
    <message>
      <source>There is no measurement of this kind.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει μέτρηση αυτού του είδους.</translation>
    </message>
    <message>
      <source>A measurement cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια μέτρηση δεν είναι ποτέ κάτω από 0.</translation>
    </message>
    <message>
      <source>A newer Ostraka made this project (catalogue version %1, this program supports %2). Nothing was changed. Install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα νεότερο Ostraka έφτιαξε αυτό το έργο (κατάλογος έκδοση %1, αυτό το πρόγραμμα υποστηρίζει %2). Τίποτα δεν άλλαξε. Εγκαταστήστε τη νεότερη έκδοση.</translation>
    </message>
    <message>
      <source>The numbering cannot contain the character &apos;%1&apos;; letters, digits, &apos;.&apos;, &apos;_&apos;, &apos;/&apos; and &apos;-&apos; are allowed between the tokens.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αρίθμηση δεν μπορεί να περιέχει τον χαρακτήρα '%1'· ανάμεσα στα σύμβολα επιτρέπονται γράμματα, ψηφία, '.', '_', '/' και '-'.</translation>
    </message>
    <message>
      <source>The numbering opens a token with { and does not close it with }.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αρίθμηση ανοίγει ένα σύμβολο με { και δεν το κλείνει με }.</translation>
    </message>
    <message>
      <source>The numbering has no token {%1}; available: site, trench, context, bag, batch, yyyy, yy and n.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αρίθμηση δεν έχει σύμβολο {%1}· υπάρχουν site, trench, context, bag, batch, yyyy, yy και n.</translation>
    </message>
    <message>
      <source>The width of {%1} must be written as :04, with 12 digits at most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πλάτος του {%1} πρέπει να γράφεται όπως :04, με 12 ψηφία το πολύ.</translation>
    </message>
    <message>
      <source>Two tokens are adjacent; put &apos;-&apos; or another character between {%1} and {%2}.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο σύμβολα αγγίζονται· βάλτε ένα '-' ή άλλο σημείο ανάμεσα στο {%1} και το {%2}.</translation>
    </message>
    <message>
      <source>The numbering must count the sherds with {n} exactly once.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η αρίθμηση πρέπει να μετρά τα όστρακα με {n} ακριβώς μία φορά.</translation>
    </message>
    <message>
      <source>The number needs the site of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός χρειάζεται τη θέση του οστράκου, που δεν έχει καταχωριστεί.</translation>
    </message>
    <message>
      <source>The number needs the context of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός χρειάζεται το πλαίσιο του οστράκου, που δεν έχει καταχωριστεί.</translation>
    </message>
    <message>
      <source>The number needs the bag of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός χρειάζεται τη σακούλα του οστράκου, που δεν έχει καταχωριστεί.</translation>
    </message>
    <message>
      <source>The number needs the batch of the sherd, which is not recorded.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός χρειάζεται την παρτίδα του οστράκου, που δεν έχει καταχωριστεί.</translation>
    </message>
    <message>
      <source>The site %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η θέση %1 περιέχει το σημείο '%2' που βρίσκεται δίπλα της στον αριθμό.</translation>
    </message>
    <message>
      <source>The trench %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η τομή %1 περιέχει το σημείο '%2' που βρίσκεται δίπλα της στον αριθμό.</translation>
    </message>
    <message>
      <source>The context %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πλαίσιο %1 περιέχει το σημείο '%2' που βρίσκεται δίπλα του στον αριθμό.</translation>
    </message>
    <message>
      <source>The bag %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σακούλα %1 περιέχει το σημείο '%2' που βρίσκεται δίπλα της στον αριθμό.</translation>
    </message>
    <message>
      <source>The batch %1 contains the character &apos;%2&apos; that is next to it in the number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα %1 περιέχει το σημείο '%2' που βρίσκεται δίπλα της στον αριθμό.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before; numbers are never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 έχει δοθεί παλιότερα· οι αριθμοί δεν ξαναχρησιμοποιούνται.</translation>
    </message>
    <message>
      <source>The block of numbers up to %1 is used up; assign this computer a new block in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σειρά αριθμών ως το %1 εξαντλήθηκε· δώστε σε αυτόν τον υπολογιστή νέα σειρά στις ρυθμίσεις.</translation>
    </message>
    <message>
      <source>A decision needs the name of the person who makes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια απόφαση χρειάζεται το όνομα του ατόμου που την παίρνει.</translation>
    </message>
    <message>
      <source>A merge needs two or more fragments.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια συγχώνευση χρειάζεται δύο ή περισσότερα θραύσματα.</translation>
    </message>
    <message>
      <source>A split needs exactly one fragment.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια διαίρεση χρειάζεται ακριβώς ένα θραύσμα.</translation>
    </message>
    <message>
      <source>The name of a person must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα ενός ατόμου δεν πρέπει να είναι κενό.</translation>
    </message>
    <message>
      <source>The person's initials must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά του ατόμου δεν πρέπει να είναι κενά.</translation>
    </message>
    <message>
      <source>The code of a site must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός μιας θέσης δεν πρέπει να είναι κενός.</translation>
    </message>
    <message>
      <source>The code of a trench must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός μιας τομής δεν πρέπει να είναι κενός.</translation>
    </message>
    <message>
      <source>The number of a context must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός ενός πλαισίου δεν πρέπει να είναι κενός.</translation>
    </message>
    <message>
      <source>The number of a bag must not be empty.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός μιας σακούλας δεν πρέπει να είναι κενός.</translation>
    </message>
    <message>
      <source>The name of a person must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα ενός ατόμου είναι πολύ μεγάλο· το πολύ 200 γράμματα.</translation>
    </message>
    <message>
      <source>The person&apos;s initials must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά του ατόμου είναι πολύ μεγάλα· το πολύ 200 γράμματα.</translation>
    </message>
    <message>
      <source>The code of a site must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός μιας θέσης είναι πολύ μεγάλος· το πολύ 200 γράμματα.</translation>
    </message>
    <message>
      <source>The code of a trench must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κωδικός μιας τομής είναι πολύ μεγάλος· το πολύ 200 γράμματα.</translation>
    </message>
    <message>
      <source>The number of a context must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός ενός πλαισίου είναι πολύ μεγάλος· το πολύ 200 γράμματα.</translation>
    </message>
    <message>
      <source>The number of a bag must have at most 200 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός μιας σακούλας είναι πολύ μεγάλος· το πολύ 200 γράμματα.</translation>
    </message>
    <message>
      <source>The uuid is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το uuid δεν είναι σωστά γραμμένο.</translation>
    </message>
    <message>
      <source>The initials %1 already belong to another person.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχικά %1 ανήκουν ήδη σε άλλο άτομο.</translation>
    </message>
    <message>
      <source>The latitude must be between -90 and 90 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το γεωγραφικό πλάτος είναι μεταξύ -90 και 90 μοιρών.</translation>
    </message>
    <message>
      <source>The longitude must be between -180 and 180 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το γεωγραφικό μήκος είναι μεταξύ -180 και 180 μοιρών.</translation>
    </message>
    <message>
      <source>The site %1 already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη θέση %1.</translation>
    </message>
    <message>
      <source>A trench needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια τομή ανήκει σε μια θέση.</translation>
    </message>
    <message>
      <source>A trench cannot contain itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια τομή δεν μπορεί να βρίσκεται μέσα στον εαυτό της.</translation>
    </message>
    <message>
      <source>The trench %1 already exists in this site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη τομή %1 σε αυτή τη θέση.</translation>
    </message>
    <message>
      <source>A context needs a site.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα πλαίσιο ανήκει σε μια θέση.</translation>
    </message>
    <message>
      <source>The trench and the context belong to different sites.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η τομή ανήκει σε άλλη θέση από το πλαίσιο.</translation>
    </message>
    <message>
      <source>The context %1 already exists in this place.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη πλαίσιο %1 σε αυτό το σημείο.</translation>
    </message>
    <message>
      <source>A bag needs a context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια σακούλα ανήκει σε ένα πλαίσιο.</translation>
    </message>
    <message>
      <source>The weight of a bag must be greater than 0 g.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το βάρος μιας σακούλας είναι πάνω από 0 g.</translation>
    </message>
    <message>
      <source>A count cannot be less than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα πλήθος δεν είναι ποτέ κάτω από 0.</translation>
    </message>
    <message>
      <source>The bag %1 already exists in this context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη σακούλα %1 σε αυτό το πλαίσιο.</translation>
    </message>
    <message>
      <source>The folder is on a network share (%1), which can damage catalogues; use a folder on this computer&apos;s own disk and copy backups to the share.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος βρίσκεται σε κοινόχρηστο δίκτυο (%1), όπου οι κατάλογοι καταστρέφονται· χρησιμοποιήστε φάκελο στον δίσκο αυτού του υπολογιστή και αντιγράψτε τα αντίγραφα ασφαλείας στο δίκτυο.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος δεν είναι έργο Ostraka: δεν περιέχει catalogue.sqlite.</translation>
    </message>
    <message>
      <source>A new project needs a new or empty folder; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα νέο έργο χρειάζεται νέο ή άδειο φάκελο· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>The folder cannot be created; choose a location that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος δεν μπορεί να δημιουργηθεί· επιλέξτε θέση όπου επιτρέπεται η εγγραφή.</translation>
    </message>
    <message>
      <source>A uuid of the export is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα uuid της εξαγωγής δεν είναι σωστά γραμμένο.</translation>
    </message>
    <message>
      <source>The decision is saved with the batch, but %1 is not in the catalogue yet; it is added with the next results.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση αποθηκεύτηκε με την παρτίδα, αλλά το %1 δεν είναι ακόμη στον κατάλογο· θα καταχωριστεί με τα επόμενα αποτελέσματα.</translation>
    </message>
    <message>
      <source>The field %1 is read-only: the program sets it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πεδίο %1 προέρχεται από το πρόγραμμα.</translation>
    </message>
    <message>
      <source>A void sherd keeps its number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα άκυρο όστρακο κρατά τον αριθμό του.</translation>
    </message>
    <message>
      <source>A number cannot contain a line break, a tab or &apos;%&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας αριθμός δεν περιέχει αλλαγή γραμμής, στηλοθέτη ή '%'.</translation>
    </message>
    <message>
      <source>A number or code cannot contain invisible characters; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας αριθμός ή κωδικός δεν μπορεί να περιέχει αόρατους χαρακτήρες· πληκτρολογήστε τον ξανά.</translation>
    </message>
    <message>
      <source>A number has at most 120 characters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας αριθμός έχει το πολύ 120 χαρακτήρες.</translation>
    </message>
    <message>
      <source>The number %1 would be assigned twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 θα δινόταν δύο φορές.</translation>
    </message>
    <message>
      <source>The files of %1 would have the same names as those of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αρχεία του %1 θα είχαν τα ίδια ονόματα με εκείνα του %2.</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 έχει δοθεί παλιότερα και δεν ξαναχρησιμοποιείται.</translation>
    </message>
    <message>
      <source>The number %1 belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 ανήκει σε άλλο όστρακο.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0 after ±, or 0 if the uncertainty is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι ακολουθεί το σύμβολο ± είναι μεγαλύτερο από το 0, ή 0 όπου δεν είναι γνωστή αβεβαιότητα.</translation>
    </message>
    <message>
      <source>Enter a value greater than 0.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια μέτρηση είναι πάνω από 0.</translation>
    </message>
    <message>
      <source>No sherd is larger than 1000 mm; check that the value is in millimetres.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα όστρακο δεν είναι μεγαλύτερο από 1000 mm· είναι σε χιλιοστά;</translation>
    </message>
    <message>
      <source>No sherd is heavier than 20 kg; check that the value is in grams.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα όστρακο δεν είναι βαρύτερο από 20 kg· είναι σε γραμμάρια;</translation>
    </message>
    <message>
      <source>A share cannot exceed 100 %.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα ποσοστό είναι το πολύ 100 %.</translation>
    </message>
    <message>
      <source>There is no sherd %1 to join.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει όστρακο %1 με το οποίο θα μπορούσε να συνανήκει.</translation>
    </message>
    <message>
      <source>A sherd cannot join itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο δεν συνανήκει με τον εαυτό του.</translation>
    </message>
    <message>
      <source>There is no context %1 in %2; add it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει πλαίσιο %1 στο %2· προσθέστε το πρώτα.</translation>
    </message>
    <message>
      <source>A numbered sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα αριθμημένο όστρακο χρειάζεται το πλαίσιό του.</translation>
    </message>
    <message>
      <source>A sherd needs its context before it gets a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο παίρνει αριθμό όταν το πλαίσιό του είναι γνωστό.</translation>
    </message>
    <message>
      <source>The table cannot be sorted by &apos;%1&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας δεν ταξινομείται κατά '%1'.</translation>
    </message>
    <message>
      <source>A sherd is no longer in the catalogue.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο δεν είναι πια στον κατάλογο.</translation>
    </message>
    <message>
      <source>The uuid of a sherd is not well formed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το uuid ενός οστράκου δεν είναι σωστά γραμμένο.</translation>
    </message>
    <message>
      <source>A sherd with this uuid already exists.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη όστρακο με αυτό το uuid.</translation>
    </message>
    <message>
      <source>A void sherd needs a reason; enter it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο είναι άκυρο για κάποιον λόγο· πείτε ποιον.</translation>
    </message>
    <message>
      <source>The number %1 appears on two sherds of this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 υπάρχει σε δύο όστρακα αυτού του δίσκου.</translation>
    </message>
    <message>
      <source>The number %1 already belongs to another sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 ανήκει ήδη σε άλλο όστρακο.</translation>
    </message>
    <message>
      <source>The sherd of this label has no number yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο αυτής της ετικέτας δεν έχει ακόμη αριθμό.</translation>
    </message>
    <message>
      <source>The text is longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το κείμενο είναι μεγαλύτερο από 1 MB.</translation>
    </message>
    <message>
      <source>The text is not valid UTF-8 or contains a zero byte.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το κείμενο δεν είναι έγκυρο UTF-8 ή περιέχει μηδενικό byte.</translation>
    </message>
    <message>
      <source>The text contains control characters, which documents cannot contain; type it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το κείμενο περιέχει χαρακτήρες ελέγχου, που τα έγγραφα δεν μπορούν να περιέχουν· πληκτρολογήστε το ξανά.</translation>
    </message>
    <message>
      <source>Write the day as 2026-07-14 (year-month-day).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια ημέρα γράφεται 2026-07-14 (έτος-μήνας-ημέρα).</translation>
    </message>
    <message>
      <source>Write the Munsell colour as 10YR 3/1 or N 4/.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα χρώμα Munsell γράφεται 10YR 3/1 ή N 4/.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a number; write 12.5 or 12,5, without a unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το '%1' δεν είναι αριθμός· γράψτε 12.5 ή 12,5, χωρίς μονάδα.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a path inside its folder; it must be relative, with &apos;/&apos; and without &apos;..&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το '%1' δεν είναι διαδρομή μέσα στον φάκελό της· πρέπει να είναι σχετική, με '/' και χωρίς '..'.</translation>
    </message>
    <message>
      <source>Not a PLY file; choose one, or export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι αρχείο PLY· δώστε ένα ή εξαγάγετε ξανά τη σάρωση.</translation>
    </message>
    <message>
      <source>The PLY header states no format; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κεφαλίδα PLY δεν δηλώνει μορφή· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>The PLY header has an error in line %1: %2; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κεφαλίδα PLY έχει λάθος στη γραμμή %1: %2· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>its format is unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η μορφή του δεν είναι γνωστή</translation>
    </message>
    <message>
      <source>a count is not a number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ένα πλήθος δεν είναι αριθμός</translation>
    </message>
    <message>
      <source>a property cannot be read</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μια ιδιότητα δεν διαβάζεται</translation>
    </message>
    <message>
      <source>a property has an unknown type</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μια ιδιότητα έχει άγνωστο τύπο</translation>
    </message>
    <message>
      <source>the length of a list is not a whole number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το μήκος μιας λίστας δεν είναι ακέραιος αριθμός</translation>
    </message>
    <message>
      <source>a line cannot be parsed</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μια γραμμή δεν είναι κατανοητή</translation>
    </message>
    <message>
      <source>The PLY header has no end; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κεφαλίδα PLY δεν έχει τέλος· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>The PLY header declares %1 of &apos;%2&apos;, more than the file contains; the file may be truncated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κεφαλίδα PLY δηλώνει %1 '%2', περισσότερα από όσα περιέχει το αρχείο· ίσως είναι κομμένο.</translation>
    </message>
    <message>
      <source>The PLY file has two lists of vertices; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY έχει δύο λίστες κορυφών· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>The PLY vertices lack x, y or z; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από τις κορυφές του PLY λείπει το x, το y ή το z· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>The PLY file ends early or contains a value that is not a number; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY τελειώνει νωρίς ή περιέχει κάτι που δεν είναι αριθμός· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>A face of the PLY file refers to a vertex that does not exist; export the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια όψη του PLY ονομάζει κορυφή που δεν υπάρχει· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>The PLY file ends within '%1'; copy it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY τελειώνει μέσα στο '%1'· αντιγράψτε το ξανά.</translation>
    </message>
    <message>
      <source>The PLY file has no vertices; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY δεν έχει κορυφές· εξαγάγετε ξανά τη σάρωση.</translation>
    </message>
    <message>
      <source>The PLY file states its unit as &apos;%1&apos;, but lengths must be in mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY δηλώνει μονάδα '%1', αλλά τα μήκη πρέπει να είναι σε mm· εξαγάγετέ το σε mm.</translation>
    </message>
    <message>
      <source>The PLY file contains more data than its header declares; export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY περιέχει περισσότερα από όσα δηλώνει η κεφαλίδα του· εξαγάγετέ το ξανά.</translation>
    </message>
    <message>
      <source>The PLY file contains no usable points; export the scan again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY δεν περιέχει κανένα χρήσιμο σημείο· εξαγάγετε ξανά τη σάρωση.</translation>
    </message>
    <message>
      <source>No part of the edge can be a rim; draw this sherd without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένα τμήμα της ακμής δεν μπορεί να είναι χείλος· σχεδιάστε αυτό το όστρακο ως όστρακο χωρίς χείλος.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %), so no diameter is given; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό που θεωρήθηκε χείλος μόλις που του μοιάζει (%1 %), γι’ αυτό δεν δίνεται διάμετρος· ελέγξτε πώς στέκεται το όστρακο.</translation>
    </message>
    <message>
      <source>The preserved rim is too short or too straight for a diameter; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το τμήμα του χείλους είναι πολύ μικρό ή πολύ ευθύ για να δοθεί διάμετρος· ελέγξτε πώς στέκεται το όστρακο.</translation>
    </message>
    <message>
      <source>Drawn as a rim sherd, which is likely (%1 %); check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχεδιάστηκε ως χείλος, που είναι πιθανό (%1 %)· ελέγξτε το.</translation>
    </message>
    <message>
      <source>This may be a rim sherd (%1 %); if it is, mark it as one and redraw it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ίσως είναι χείλος (%1 %)· αν είναι, δηλώστε το και σχεδιάστε το ξανά.</translation>
    </message>
    <message>
      <source>The drawing&apos;s scale must be between 1:20 and 5:1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κλίμακα του σχεδίου πρέπει να είναι μεταξύ 1:20 και 5:1.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model (%1); create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα σχέδιο χρειάζεται κλειστό μοντέλο (%1)· φτιάξτε το με το 'ostraka process'.</translation>
    </message>
    <message>
      <source>A drawing needs a closed model; create one with &apos;ostraka process&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα σχέδιο χρειάζεται κλειστό μοντέλο· φτιάξτε το με το 'ostraka process'.</translation>
    </message>
    <message>
      <source>The manifest is missing; not an Ostraka export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπει ο κατάλογος των αρχείων (manifest)· δεν είναι εξαγωγή του Ostraka.</translation>
    </message>
    <message>
      <source>The manifest has a line that cannot be read (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μανιφέστο έχει γραμμή που δεν διαβάζεται (%1), γι’ αυτό δεν διαβάστηκε τίποτα· αντιγράψτε ξανά τον φάκελο.</translation>
    </message>
    <message>
      <source>The manifest names a file outside the folder (%1), so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μανιφέστο αναφέρει αρχείο έξω από τον φάκελο (%1), γι’ αυτό δεν διαβάστηκε τίποτα· αντιγράψτε ξανά τον φάκελο.</translation>
    </message>
    <message>
      <source>The manifest names the file %1 twice, so nothing was read; copy the folder again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μανιφέστο αναφέρει δύο φορές το αρχείο %1, γι’ αυτό δεν διαβάστηκε τίποτα· αντιγράψτε ξανά τον φάκελο.</translation>
    </message>
    <message>
      <source>A folder with this name already exists; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη φάκελος με αυτό το όνομα· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>Not every system supports names with a line break, a backslash or characters that are not UTF-8; rename this file or folder, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όνομα με αλλαγή γραμμής, ανάστροφη κάθετο ή χαρακτήρες που δεν είναι UTF-8 δεν διατηρείται σε όλα τα συστήματα· μετονομάστε αυτό το αρχείο ή τον φάκελο και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>On some systems this is the same name as %1; rename one of the two, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε ορισμένα συστήματα αυτό το όνομα είναι ίδιο με το %1· μετονομάστε ένα από τα δύο και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>Project A has another file with this name, which its catalogue does not list; nothing was merged. Move that file elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο A έχει άλλο αρχείο με αυτό το όνομα, που ο κατάλογός του δεν γνωρίζει· μετακινήστε το, τίποτα δεν συγχωνεύτηκε.</translation>
    </message>
    <message>
      <source>Two files of the export would have the same name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο αρχεία της εξαγωγής θα είχαν το ίδιο όνομα.</translation>
    </message>
    <message>
      <source>Another import into this project is running; this one waits until it has finished.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια άλλη εισαγωγή σε αυτό το έργο βρίσκεται σε εξέλιξη· αυτή περιμένει να τελειώσει.</translation>
    </message>
    <message>
      <source>Files that were missing from the project and are restored: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αρχεία που έλειπαν από το έργο και επανήλθαν: %1.</translation>
    </message>
    <message>
      <source>A folder with this name was created in the meantime; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάποιος δημιούργησε εν τω μεταξύ φάκελο με αυτό το όνομα· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>Not an Ostraka export: this folder has no bagit.txt.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος δεν είναι εξαγωγή του Ostraka: λείπει το bagit.txt.</translation>
    </message>
    <message>
      <source>This file is not in the manifest; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο δεν είναι στον κατάλογο των αρχείων (manifest)· δεν διαβάστηκε τίποτα.</translation>
    </message>
    <message>
      <source>This is a link, not a file; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι σύνδεσμος, όχι αρχείο· δεν διαβάστηκε τίποτα.</translation>
    </message>
    <message>
      <source>This folder cannot be read (%1); nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος δεν διαβάζεται (%1)· δεν διαβάστηκε τίποτα.</translation>
    </message>
    <message>
      <source>This file is missing; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο λείπει· δεν διαβάστηκε τίποτα.</translation>
    </message>
    <message>
      <source>This file has changed since the export; nothing was read.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο άλλαξε μετά την εξαγωγή· δεν διαβάστηκε τίποτα.</translation>
    </message>
    <message>
      <source>The column &apos;closed&apos; accepts only yes or no.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η στήλη closed δέχεται yes ή no.</translation>
    </message>
    <message>
      <source>The column &apos;count_written&apos; accepts only a whole number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η στήλη count_written δέχεται ακέραιο αριθμό.</translation>
    </message>
    <message>
      <source>Values in the row: %1, columns in the header: %2; correct the row.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τιμές στη γραμμή: %1, στήλες στην επικεφαλίδα: %2· διορθώστε τη γραμμή.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; is unknown; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η στήλη '%1' δεν είναι γνωστή· οι τιμές της κρατιούνται ως δικό σας πεδίο.</translation>
    </message>
    <message>
      <source>Not a text file: it contains binary data, which a table never does.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο δεν είναι κείμενο: περιέχει δυαδικά δεδομένα, που κανένας πίνακας δεν έχει.</translation>
    </message>
    <message>
      <source>This is a spreadsheet (ODS, XLSX), not a CSV table; save the sheet as 'CSV UTF-8' and import that file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι υπολογιστικό φύλλο (ODS, XLSX), όχι πίνακας CSV· αποθηκεύστε το φύλλο ως 'CSV UTF-8' και εισαγάγετε εκείνο το αρχείο.</translation>
    </message>
    <message>
      <source>Line %1 is not in UTF-8; save the table as 'CSV UTF-8' and try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γραμμή %1 δεν είναι σε UTF-8· αποθηκεύστε τον πίνακα ως 'CSV UTF-8' και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>The table has more than 1,000,000 rows; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας έχει πάνω από 1.000.000 γραμμές· χωρίστε τον.</translation>
    </message>
    <message>
      <source>The table has more than 1,000 columns; split it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας έχει πάνω από 1.000 στήλες· χωρίστε τον.</translation>
    </message>
    <message>
      <source>Line %1 has an unclosed quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γραμμή %1 ανοίγει εισαγωγικά που δεν κλείνουν ποτέ.</translation>
    </message>
    <message>
      <source>Line %1 has characters after a closing quotation mark.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γραμμή %1 έχει γράμματα μετά από εισαγωγικά που κλείνουν.</translation>
    </message>
    <message>
      <source>Line %1 has a value longer than 1 MB.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γραμμή %1 έχει τιμή μεγαλύτερη από 1 MB.</translation>
    </message>
    <message>
      <source>The table is empty; its first line must name the columns.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας είναι άδειος· η πρώτη του γραμμή πρέπει να ονομάζει τις στήλες.</translation>
    </message>
    <message>
      <source>This sherd has no model yet, so it cannot be drawn; process its batch first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το όστρακο δεν έχει ακόμη μοντέλο και δεν μπορεί να σχεδιαστεί· επεξεργαστείτε πρώτα την παρτίδα του.</translation>
    </message>
    <message>
      <source>The measurements of its batch are in doubt, and so is the size of this drawing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι μετρήσεις της παρτίδας του είναι αμφίβολες: το ίδιο και το μέγεθος αυτού του σχεδίου.</translation>
    </message>
    <message>
      <source>The sherd is recorded as a rim, but no part of its edge can be one; it is drawn without a rim.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δηλώθηκε ως χείλος, αλλά κανένα τμήμα της ακμής του δεν μπορεί να είναι· σχεδιάστηκε χωρίς αυτό.</translation>
    </message>
    <message>
      <source>%1 is missing and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 δεν υπάρχει και παραλείφθηκε.</translation>
    </message>
    <message>
      <source>%1 differs from the recorded photograph; check it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 δεν είναι η φωτογραφία που καταχωρίστηκε· ελέγξτε την.</translation>
    </message>
    <message>
      <source>This model or picture of the sherd %1 differs from the recorded one; reprocess its batch %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το μοντέλο ή η εικόνα του οστράκου %1 διαφέρει από το καταχωρισμένο· επανεπεξεργαστείτε την παρτίδα του %2.</translation>
    </message>
    <message>
      <source>%1 is exported in full detail: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 εξάγεται ολόκληρο: %2</translation>
    </message>
    <message>
      <source>%1 is exported without photographs: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 εξάγεται χωρίς φωτογραφίες: %2</translation>
    </message>
    <message>
      <source>Photographs can be projected only onto a closed model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες δεν μπορούν να τοποθετηθούν σε μοντέλο που δεν είναι κλειστό.</translation>
    </message>
    <message>
      <source>Not drawn: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν σχεδιάστηκε: %1</translation>
    </message>
    <message>
      <source>Drawn without its photographs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σχεδιάστηκε χωρίς τις φωτογραφίες του: %1</translation>
    </message>
    <message>
      <source>No pictures with masks and poses of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς εικόνες με μάσκες και θέσεις της %1: %2</translation>
    </message>
    <message>
      <source>No sherds to export; select some first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει όστρακο για εξαγωγή· επιλέξτε πρώτα μερικά.</translation>
    </message>
    <message>
      <source>The row has neither a number nor a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γραμμή δεν έχει ούτε αριθμό ούτε uuid.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό υπάρχει σε περισσότερες από μία γραμμές του πίνακα, στις γραμμές %1.</translation>
    </message>
    <message>
      <source>This appears in more than one row of the table, in the lines %1 and %2 more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό υπάρχει σε περισσότερες από μία γραμμές του πίνακα, στις γραμμές %1 και σε %2 ακόμη.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is unusual for a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε τη μονάδα: %1 είναι ασυνήθιστο για όστρακο.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is far from the other values of this column.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε τη μονάδα: %1 απέχει πολύ από τις άλλες τιμές αυτής της στήλης.</translation>
    </message>
    <message>
      <source>Not a uuid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι uuid.</translation>
    </message>
    <message>
      <source>The number and the uuid belong to different sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός ανήκει σε άλλο όστρακο από το uuid.</translation>
    </message>
    <message>
      <source>A new sherd needs its context.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα νέο όστρακο χρειάζεται το πλαίσιό του.</translation>
    </message>
    <message>
      <source>A column of the table has no name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια στήλη του πίνακα δεν έχει όνομα.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; appears twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η στήλη '%1' υπάρχει δύο φορές.</translation>
    </message>
    <message>
      <source>These places and batches are not in Ostraka&apos;s format.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτοί οι τόποι και οι παρτίδες δεν είναι γραμμένοι όπως τους γράφει το Ostraka.</translation>
    </message>
    <message>
      <source>Not a PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι αρχείο PLY.</translation>
    </message>
    <message>
      <source>Not a GLB file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι αρχείο GLB.</translation>
    </message>
    <message>
      <source>This export contains no sherd records (JSON); export it again with them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η εξαγωγή δεν περιέχει εγγραφές (JSON) οστράκων· εξαγάγετέ την ξανά με αυτές.</translation>
    </message>
    <message>
      <source>The project already has this sherd with other values, which it keeps; the differing values are added in fields that end in _in_%1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο έχει αυτό το όστρακο με άλλες τιμές· αυτές μένουν, και ό,τι διαφέρει κρατιέται δίπλα τους σε πεδία που τελειώνουν σε _in_%1.</translation>
    </message>
    <message>
      <source>This file is not part of the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο δεν είναι ανάμεσα στα αρχεία της εξαγωγής.</translation>
    </message>
    <message>
      <source>The project has another file with this name; rename the export and import it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο έχει άλλο αρχείο με αυτό το όνομα· μετονομάστε την εξαγωγή και εισαγάγετέ την ξανά.</translation>
    </message>
    <message>
      <source>Not a sherd record (ostraka-sherd/1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι εγγραφή οστράκου (ostraka-sherd/1).</translation>
    </message>
    <message>
      <source>The measurement %1 has a unit other than %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μέτρηση %1 έχει άλλη μονάδα από %2.</translation>
    </message>
    <message>
      <source>A value of the record has the wrong type.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια τιμή της εγγραφής έχει άλλον τύπο από αυτόν που πρέπει.</translation>
    </message>
    <message>
      <source>This is too large for one ZIP file; select fewer sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι πολύ μεγάλο για ένα αρχείο ZIP· επιλέξτε λιγότερα όστρακα.</translation>
    </message>
    <message>
      <source>The mask is missing; expected a mask of %1 x %2 pixels under this name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μάσκα λείπει· αναμένεται με αυτό το όνομα μια μάσκα %1 x %2 εικονοστοιχείων.</translation>
    </message>
    <message>
      <source>The mask cannot be read as a picture; expected a mask of %1 x %2 pixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μάσκα δεν διαβάζεται ως εικόνα· αναμένεται μάσκα %1 x %2 εικονοστοιχείων.</translation>
    </message>
    <message>
      <source>The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μάσκα έχει %1 x %2 εικονοστοιχεία· αναμένεται μάσκα %3 x %4 εικονοστοιχείων, όσο η φωτογραφία της.</translation>
    </message>
    <message>
      <source>Masks from the plate need at least 3 photographs of a side; photograph more positions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι μάσκες από τον δίσκο χρειάζονται τουλάχιστον 3 φωτογραφίες μιας όψης· φωτογραφίστε περισσότερες στάσεις.</translation>
    </message>
    <message>
      <source>The photograph differs in size from its camera&apos;s images; use the original file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία δεν έχει το μέγεθος της κάμεράς της· χρησιμοποιήστε το αρχικό αρχείο.</translation>
    </message>
    <message>
      <source>No sherd was found on the plate; check that the photographs show sherds that stand out from the plate, or provide masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε όστρακο στον δίσκο· ελέγξτε ότι οι φωτογραφίες δείχνουν όστρακα που ξεχωρίζουν από τον δίσκο, ή δώστε μάσκες.</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 differs in size from the camera&apos;s other photographs; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μάσκες: ο άδειος δίσκος της κάμερας %1 έχει άλλο μέγεθος από τις φωτογραφίες της κάμερας· οι μάσκες έγιναν χωρίς αυτόν</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows the plate at none of the positions; retake it at the first; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μάσκες: ο άδειος δίσκος της κάμερας %1 δεν δείχνει τον δίσκο σε καμία από τις στάσεις· τραβήξτε τον ξανά στην πρώτη· οι μάσκες έγιναν χωρίς αυτόν</translation>
    </message>
    <message>
      <source>masks: the empty-plate photograph of camera %1 shows covered markers in %2; uncover them; masks are made without it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μάσκες: ο άδειος δίσκος της κάμερας %1 δείχνει δείκτες που κάτι τους καλύπτει στο %2· αφαιρέστε ό,τι είναι πάνω τους· οι μάσκες έγιναν χωρίς αυτόν</translation>
    </message>
    <message>
      <source>masks: a shadow that the other photographs do not show falls on the plate in %1; keep people and hands out of the light, and retake these if their masks look wrong</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μάσκες: μια σκιά που οι άλλες φωτογραφίες δεν έχουν πέφτει στον δίσκο στο %1· κρατήστε ανθρώπους και χέρια έξω από το φως, και τραβήξτε ξανά αυτές τις φωτογραφίες αν οι μάσκες τους φαίνονται λάθος</translation>
    </message>
    <message>
      <source>%1 (%2 % of the bare plate)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 (%2 % του γυμνού δίσκου)</translation>
    </message>
    <message>
      <source>masks: flat objects that look like labels or scale bars are left out (%1); if there are sherds among them, add them to the masks</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μάσκες: επίπεδα πράγματα που μοιάζουν με ετικέτες ή κλίμακες παραλείπονται (%1)· αν υπάρχουν όστρακα ανάμεσά τους, προσθέστε τα στις μάσκες</translation>
    </message>
    <message>
      <source>The front scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση της μπροστινής όψης δεν περιέχει σημεία.</translation>
    </message>
    <message>
      <source>The front scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση της μπροστινής όψης δεν έχει κάθετα διανύσματα· ένα μοντέλο πρέπει να ξέρει τι είναι έξω.</translation>
    </message>
    <message>
      <source>The back scan contains no points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση της πίσω όψης δεν περιέχει σημεία.</translation>
    </message>
    <message>
      <source>The back scan has no normals; a model needs them to tell outside from inside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση της πίσω όψης δεν έχει κάθετα διανύσματα· ένα μοντέλο πρέπει να ξέρει τι είναι έξω.</translation>
    </message>
    <message>
      <source>The scans do not enclose a volume; their normals may point inward.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι σαρώσεις δεν περικλείουν σώμα· ίσως τα κάθετα διανύσματά τους δείχνουν προς τα μέσα.</translation>
    </message>
    <message>
      <source>Only a closed mesh can be simplified.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μόνο ένα κλειστό πλέγμα μπορεί να αραιωθεί.</translation>
    </message>
    <message>
      <source>The deviation of a simplified mesh must be greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόκλιση ενός αραιωμένου πλέγματος πρέπει να είναι πάνω από 0 mm.</translation>
    </message>
    <message>
      <source>The scan is too large for a model at this spacing; use a larger spacing.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση είναι πολύ μεγάλη για μοντέλο με αυτή την πυκνότητα σημείων· δώστε μεγαλύτερη απόσταση.</translation>
    </message>
    <message>
      <source>The scans contain too few points that agree with each other for a model.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι σαρώσεις έχουν πολύ λίγα σημεία που συμφωνούν μεταξύ τους για ένα μοντέλο.</translation>
    </message>
    <message>
      <source>This model is %1 mm in size, larger than any vessel, so its unit is probably not mm; export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το μοντέλο έχει μέγεθος %1 mm, μεγαλύτερο από κάθε αγγείο, άρα η μονάδα του φαίνεται να είναι άλλη· εξαγάγετέ το σε mm.</translation>
    </message>
    <message>
      <source>This model is only %1 mm in size, smaller than any sherd, so its unit is probably not mm (%2); export it in mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το μοντέλο έχει μέγεθος μόνο %1 mm, λιγότερο από κάθε όστρακο, άρα η μονάδα του είναι μάλλον άλλη (%2)· εξαγάγετέ το σε mm.</translation>
    </message>
    <message>
      <source>Edge %1 is used more than once in the same direction.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ακμή %1 χρησιμοποιείται πάνω από μία φορά προς την ίδια κατεύθυνση.</translation>
    </message>
    <message>
      <source>Edge %1 has a face on one side only.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ακμή %1 έχει έδρα μόνο στη μία πλευρά.</translation>
    </message>
    <message>
      <source>Vertex %1 belongs to no face.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κορυφή %1 δεν ανήκει σε καμία έδρα.</translation>
    </message>
    <message>
      <source>Vertex %1 joins two separate fans of faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κορυφή %1 κρατά μαζί δύο βεντάλιες εδρών.</translation>
    </message>
    <message>
      <source>The mesh has no faces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πλέγμα δεν έχει έδρες.</translation>
    </message>
    <message>
      <source>A face refers to a vertex that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια έδρα ονομάζει κορυφή που δεν υπάρχει.</translation>
    </message>
    <message>
      <source>A face has the same vertex twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια έδρα έχει δύο φορές την ίδια κορυφή.</translation>
    </message>
    <message>
      <source>The scan&apos;s outline is not closed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περίγραμμα της σάρωσης δεν κλείνει.</translation>
    </message>
    <message>
      <source>A scan of fewer than 20 points has no outline.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια σάρωση με λιγότερα από 20 σημεία δεν έχει περίγραμμα.</translation>
    </message>
    <message>
      <source>A contour needs at least three points.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα περίγραμμα χρειάζεται τουλάχιστον τρία σημεία.</translation>
    </message>
    <message>
      <source>The evidence for a pair has no valid scans or value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα στοιχεία ενός ζεύγους δεν έχουν έγκυρες σαρώσεις ή τιμή.</translation>
    </message>
    <message>
      <source>pairing: %1 stays unpaired: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ζεύγη: το %1 μένει χωρίς ταίρι: %2</translation>
    </message>
    <message>
      <source>No two outlines match, so the sizes of the two sides cannot be compared; provide a known length.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχουν δύο όμοια περιγράμματα, οπότε τα μεγέθη των όψεων δεν συγκρίνονται· δώστε ένα γνωστό μήκος.</translation>
    </message>
    <message>
      <source>A candidate refers to a scan that does not exist.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας υποψήφιος ονομάζει σάρωση που δεν υπάρχει.</translation>
    </message>
    <message>
      <source>Not a candidate table; reprocess the batch, which redoes only its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό δεν είναι πίνακας υποψηφίων· επανεπεξεργαστείτε την παρτίδα, μόνο τα ζεύγη της γίνονται εκ νέου.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, whose side has been reshot since; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση της %1 από %2 αφορά το %3, που η όψη του φωτογραφήθηκε ξανά στο μεταξύ· αποφασίστε ξανά.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 concerns %3, which is no longer on the plate; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση της %1 από %2 αφορά το %3, που δεν είναι πια πάνω στον δίσκο· αποφασίστε ξανά.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 has no effect: the later decision of %3 by %4 concerns the same scan; withdraw one of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση της %1 από %2 δεν ισχύει: η απόφαση της %3 από %4, που είναι νεότερη, αφορά την ίδια σάρωση· ανακαλέστε μία από τις δύο.</translation>
    </message>
    <message>
      <source>A decision is of an unknown kind; a newer version of Ostraka wrote it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια απόφαση είναι είδους που αυτό το πρόγραμμα δεν γνωρίζει· την έγραψε νεότερο.</translation>
    </message>
    <message>
      <source>A pair needs one front and one back.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα ζεύγος χρειάζεται μία μπροστινή και μία πίσω όψη.</translation>
    </message>
    <message>
      <source>Nothing is selected to set aside or reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ονομάστηκε τίποτα για να μπει στην άκρη ή να φωτογραφηθεί ξανά.</translation>
    </message>
    <message>
      <source>Fragments to merge must be of one side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα θραύσματα που συγχωνεύονται πρέπει να είναι της ίδιας όψης.</translation>
    </message>
    <message>
      <source>A split needs one fragment and a line of at least 1 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια διαίρεση χρειάζεται ένα θραύσμα και μια γραμμή τουλάχιστον 1 mm.</translation>
    </message>
    <message>
      <source>Nothing is selected to withdraw.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ονομάστηκε τίποτα για ανάκληση.</translation>
    </message>
    <message>
      <source>A newer version of Ostraka wrote these decisions; use that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτές οι αποφάσεις γράφτηκαν από νεότερο πρόγραμμα· χρησιμοποιήστε εκείνο.</translation>
    </message>
    <message>
      <source>Decision %1 cannot be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση %1 δεν χρησιμοποιείται.</translation>
    </message>
    <message>
      <source>Its id is missing or used twice.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αναγνωριστικό της λείπει ή χρησιμοποιείται δύο φορές.</translation>
    </message>
    <message>
      <source>It replaces more than %1 decisions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αντικαθιστά περισσότερες από %1 αποφάσεις.</translation>
    </message>
    <message>
      <source>It replaces a decision twice, or one that does not come before it in the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αντικαθιστά δύο φορές μια απόφαση, ή μια απόφαση που δεν βρίσκεται πριν από αυτήν στο αρχείο.</translation>
    </message>
    <message>
      <source>A batch can have at most %1 decisions; move this file elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια παρτίδα μπορεί να έχει το πολύ %1 αποφάσεις· μετακινήστε αυτό το αρχείο, ή επαναφέρετε ένα αντίγραφό του.</translation>
    </message>
    <message>
      <source>Correct it, or restore a copy of the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διορθώστε την, ή επαναφέρετε ένα αντίγραφο του αρχείου.</translation>
    </message>
    <message>
      <source>Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτές δεν είναι αποφάσεις αυτού του προγράμματος· μετακινήστε το αρχείο, ή επαναφέρετε ένα αντίγραφό του.</translation>
    </message>
    <message>
      <source>This decision is no longer in effect.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η απόφαση δεν ισχύει πια.</translation>
    </message>
    <message>
      <source>There is no photograph of this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει φωτογραφία αυτής της όψης.</translation>
    </message>
    <message>
      <source>The outlines of these two sides cannot be overlaid.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα περιγράμματα αυτών των δύο όψεων δεν μπαίνουν το ένα πάνω στο άλλο.</translation>
    </message>
    <message>
      <source>%1 may be two sherds that touch, %2 and %3 of the other side: split it in the review, or move them apart and reshoot its side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 ίσως είναι δύο όστρακα που αγγίζονται, τα %2 και %3 της άλλης όψης: διαιρέστε το στον έλεγχο, ή απομακρύνετέ τα και φωτογραφίστε ξανά την όψη του.</translation>
    </message>
    <message>
      <source>Not a list of mask strokes; restore an earlier one, or delete it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό δεν είναι λίστα πινελιών σε μάσκες· επαναφέρετε μια παλιότερη ή αφαιρέστε την.</translation>
    </message>
    <message>
      <source>A mask holds at most 1,000 strokes and 100,000 points; nothing is saved until you undo some.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια μάσκα χωρά το πολύ 1.000 πινελιές και 100.000 σημεία· δεν αποθηκεύεται τίποτα μέχρι να αναιρέσετε μερικές.</translation>
    </message>
    <message>
      <source>This batch has no masks yet; process it first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα δεν έχει ακόμη μάσκες· επεξεργαστείτε την πρώτα.</translation>
    </message>
    <message>
      <source>This file does not state how well the rig fits.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο δεν λέει πόσο καλά ταίριαξε η διάταξη.</translation>
    </message>
    <message>
      <source>This calibration is for other cameras than those of the batch; calibrate the rig from its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η βαθμονόμηση είναι άλλων καμερών από εκείνες που φωτογράφισαν την παρτίδα· βαθμονομήστε τη διάταξη με τις δικές της φωτογραφίες.</translation>
    </message>
    <message>
      <source>Masks cannot be made without plate.json; put masks next to the photographs, or choose a network (--masks MODEL.onnx).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς plate.json οι μάσκες δεν βρίσκονται· βάλτε μάσκες δίπλα στις φωτογραφίες, ή ονομάστε ένα δίκτυο (--masks MODEL.onnx).</translation>
    </message>
    <message>
      <source>The result has no scale: without plate.json no length is known, and lengths in mm are based on a guessed pixel size; photograph on a marker plate, lay the board of board.json beside the sherds on both sides, or mark a known length on both in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αποτέλεσμα δεν έχει κλίμακα: χωρίς plate.json κανένα μήκος δεν είναι γνωστό, και ό,τι δίνεται σε mm είναι εικασία για το μέγεθος ενός εικονοστοιχείου· φωτογραφίστε πάνω σε δίσκο με δείκτες, βάλτε τον πίνακα βαθμονόμησης του board.json δίπλα στα όστρακα και στις δύο όψεις, ή σημειώστε και στις δύο ένα γνωστό μήκος στο scale.json.</translation>
    </message>
    <message>
      <source>The output folder contains files that Ostraka did not write; choose another or an empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος εξόδου περιέχει κάτι που δεν είναι αυτού του προγράμματος· επιλέξτε άλλον ή έναν άδειο.</translation>
    </message>
    <message>
      <source>The file has changed since the batch&apos;s processing began; nothing made from it is kept. Process the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο άλλαξε αφότου άρχισε η επεξεργασία της παρτίδας· τίποτα από ό,τι έγινε με αυτό δεν κρατιέται. Επεξεργαστείτε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>The markers have sides of %1 mm in this file, but --marker-mm says %2 mm. Measure one; then correct the file, or leave the option out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δείκτες έχουν σε αυτό το αρχείο πλευρές %1 mm, αλλά το --marker-mm λέει %2 mm. Μετρήστε έναν· μετά διορθώστε το αρχείο ή παραλείψτε την επιλογή.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία είναι ίδια με την %1· παραλείπεται.</translation>
    </message>
    <message>
      <source>These results were made from the photographs of %1, not of %2; process %3 itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτά τα αποτελέσματα έγιναν από τις φωτογραφίες της %1, όχι της %2· επεξεργαστείτε την ίδια την %3.</translation>
    </message>
    <message>
      <source>These results were not made from the photographs of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτά τα αποτελέσματα δεν έγιναν από τις φωτογραφίες της %1· επεξεργαστείτε την ξανά.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2 and %3 more. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπουν από τον φάκελο της παρτίδας καταγεγραμμένες φωτογραφίες της (%1): %2 και άλλες %3. Βάλτε τις πίσω και επανεπεξεργαστείτε την παρτίδα.</translation>
    </message>
    <message>
      <source>Photographs recorded for this batch are missing from its folder (%1): %2. Put them back and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λείπουν από τον φάκελο της παρτίδας καταγεγραμμένες φωτογραφίες της (%1): %2. Βάλτε τις πίσω και επανεπεξεργαστείτε την παρτίδα.</translation>
    </message>
    <message>
      <source>The output folder contains another batch; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος εξόδου περιέχει άλλη παρτίδα· επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>The output folder contains other files; choose a new or empty folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος εξόδου περιέχει κάτι άλλο· ονομάστε έναν νέο ή άδειο φάκελο.</translation>
    </message>
    <message>
      <source>A pair refers to a scan that does not exist; delete this file and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα ζεύγος αναφέρει σάρωση που δεν υπάρχει· διαγράψτε αυτό το αρχείο και επανεπεξεργαστείτε την παρτίδα.</translation>
    </message>
    <message>
      <source>Not a pair table; delete it and reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό δεν είναι πίνακας ζευγών· διαγράψτε τον και επανεπεξεργαστείτε την παρτίδα.</translation>
    </message>
    <message>
      <source>%1 and %2 were paired by hand, but their relative pose is unknown; align the back by hand in the review: %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα %1 και %2 ενώθηκαν σε ζεύγος με το χέρι, αλλά τίποτα δεν λέει πώς βρίσκονται μεταξύ τους· στρέψτε την πίσω όψη με το χέρι στον έλεγχο: %3</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; it is left out, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Η φωτογραφία είναι θολή: οι άκρες της έχουν πλάτος %2 εικονοστοιχεία, της πιο ευκρινούς της κάμερας %3· παραλείπεται, τραβήξτε την ξανά.</translation>
    </message>
    <message>
      <source>%1: The photograph is blurred: its edges are %2 pixels wide, those of the camera&apos;s sharpest %3; retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Η φωτογραφία είναι θολή: οι άκρες της έχουν πλάτος %2 εικονοστοιχεία, της πιο ευκρινούς της κάμερας %3· τραβήξτε την ξανά.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the front side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 από τους %2 δείκτες του δίσκου δεν είναι σε καμία φωτογραφία της μπροστινής όψης (%3)· οι κάμερες στηρίζονται στους άλλους, γι' αυτό αφαιρέστε ό,τι τους καλύπτει.</translation>
    </message>
    <message>
      <source>All photographs of the back side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλες οι φωτογραφίες της πίσω όψης είναι θολές: ακόμη και στην πιο καθαρή οι άκρες των δεικτών έχουν πλάτος %1 εικονοστοιχεία, οπότε οι σαρώσεις της είναι αδρές. Ελέγξτε την εστίαση και την ταχύτητα κλείστρου και φωτογραφίστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>All photographs of the front side are blurred: even in the sharpest, the markers&apos; edges are %1 pixels wide, so its scans are coarse. Check focus and shutter speed, and reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλες οι φωτογραφίες της μπροστινής όψης είναι θολές: ακόμη και στην πιο καθαρή οι άκρες των δεικτών έχουν πλάτος %1 εικονοστοιχεία, οπότε οι σαρώσεις της είναι αδρές. Ελέγξτε την εστίαση και την ταχύτητα κλείστρου και φωτογραφίστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>%1 of the plate&apos;s %2 markers are not visible in any photograph of the back side (%3); the camera poses depend on the others, so uncover these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 από τους %2 δείκτες του δίσκου δεν είναι σε καμία φωτογραφία της πίσω όψης (%3)· οι κάμερες στηρίζονται στους άλλους, γι' αυτό αφαιρέστε ό,τι τους καλύπτει.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 merges fragments that no longer exist; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση της %1 από %2 συγχωνεύει θραύσματα που δεν υπάρχουν πια· αποφασίστε ξανά.</translation>
    </message>
    <message>
      <source>The decision of %1 by %2 splits a fragment that does not exist, or misses it; decide again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η απόφαση της %1 από %2 διαιρεί θραύσμα που δεν υπάρχει, ή το αστοχεί· αποφασίστε ξανά.</translation>
    </message>
    <message>
      <source>The program %1 is not installed, but the selected stereo needs it; install it, or use the built-in stereo.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα %1 δεν είναι εγκατεστημένο, και η στερεοσκοπία που επιλέχθηκε το χρειάζεται· εγκαταστήστε το, ή χρησιμοποιήστε την ενσωματωμένη.</translation>
    </message>
    <message>
      <source>The photographs show no marker plate, so finding the cameras needs the program %1, which is not installed; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες δεν δείχνουν δίσκο με δείκτες, οπότε το πρόγραμμα %1 πρέπει να βρει τις κάμερες, και δεν είναι εγκατεστημένο· εγκαταστήστε το.</translation>
    </message>
    <message>
      <source>This needs about %1 GB of memory, but only %2 GB are free: the computer may stop the program or become very slow.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό χρειάζεται περίπου %1 GB μνήμης, και μόνο %2 GB είναι ελεύθερα: ο υπολογιστής μπορεί να το σταματήσει ή να γίνει πολύ αργός.</translation>
    </message>
    <message>
      <source>Close other programs, or process a draft.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλείστε άλλα προγράμματα, ή επεξεργαστείτε ένα προσχέδιο.</translation>
    </message>
    <message>
      <source>%1: the camera was not in the place that it had while the plate turned; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: δεν λήφθηκε από τη θέση όπου στεκόταν η κάμερα ενώ περιστρεφόταν ο δίσκος· παραλείπεται.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 σπρώχτηκε κατά περίπου %2 mm στη μπροστινή όψη: από τη στάση %3 και μετά (pos%4) βρίσκεται αλλού· φωτογραφίστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the front side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 σπρώχτηκε κατά περίπου %2 mm στη μπροστινή όψη: από τη φωτογραφία %3 και μετά βρίσκεται αλλού· φωτογραφίστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 σπρώχτηκε κατά περίπου %2 mm στην πίσω όψη: από τη στάση %3 και μετά (pos%4) βρίσκεται αλλού· φωτογραφίστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>%1 moved by about %2 mm on the back side: from %3 on, it is in another place; reshoot this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 σπρώχτηκε κατά περίπου %2 mm στην πίσω όψη: από τη φωτογραφία %3 και μετά βρίσκεται αλλού· φωτογραφίστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>The output folder is inside the batch folder, to which Ostraka never writes; choose one next to it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος εξόδου είναι μέσα στον φάκελο της παρτίδας, όπου δεν γράφεται ποτέ τίποτα· επιλέξτε έναν δίπλα του.</translation>
    </message>
    <message>
      <source>Processing needs at least %1 GB of memory.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επεξεργασία χρειάζεται τουλάχιστον %1 GB μνήμης.</translation>
    </message>
    <message>
      <source>Photographs cannot be reduced to less than 0.3 megapixels.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες δεν μειώνονται κάτω από 0,3 μεγαπίξελ.</translation>
    </message>
    <message>
      <source>There is no such segmentation network; masks are 'auto', 'given' or an ONNX file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει τέτοιο δίκτυο τμηματοποίησης· οι μάσκες είναι 'auto', 'given' ή ένα αρχείο ONNX.</translation>
    </message>
    <message>
      <source>The fronts are not in mm: lengths in the result, although labelled mm, are in the fronts&apos; own unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι μπροστινές όψεις δεν είναι σε mm: τα μήκη του αποτελέσματος, που λέγονται mm, είναι στη μονάδα των μπροστινών όψεων.</translation>
    </message>
    <message>
      <source>The pairs of this batch are not processed yet; process the batch: complete results are kept.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα ζεύγη αυτής της παρτίδας δεν έχουν επεξεργαστεί ακόμη· επεξεργαστείτε την παρτίδα: ό,τι είναι πλήρες διατηρείται.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too small; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κλίμακα δεν είναι σωστή: %1, οπότε όλα τα μέτρα θα ήταν %2 % πολύ μικρά· μετρήστε τον χάρακα πάνω στον δίσκο και δώστε στο plate.json το πραγματικό του μέγεθος με 'ostraka plate --ruler-measured', ή τυπώστε ξανά τον δίσκο στο 100 %· αν ο δίσκος είναι σωστός, μετρήστε το μήκος και βάλτε ξανά τα σημάδια του.</translation>
    </message>
    <message>
      <source>The scale is wrong: %1, so all measurements would be %2 % too large; measure the ruler on the plate and set its true size in plate.json with &apos;ostraka plate --ruler-measured&apos;, or reprint the plate at 100 %; if the plate is correct, measure the length and set its marks again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κλίμακα δεν είναι σωστή: %1, οπότε όλα τα μέτρα θα ήταν %2 % πολύ μεγάλα· μετρήστε τον χάρακα πάνω στον δίσκο και δώστε στο plate.json το πραγματικό του μέγεθος με 'ostraka plate --ruler-measured', ή τυπώστε ξανά τον δίσκο στο 100 %· αν ο δίσκος είναι σωστός, μετρήστε το μήκος και βάλτε ξανά τα σημάδια του.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the front side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το μήκος %1 mm που σημειώθηκε στη μπροστινή όψη μετρά %2 ± %3 mm στις φωτογραφίες (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the front side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μήκος %1 mm στο scale.json δεν συγκρίθηκε: σημειώστε κάθε άκρο του σε δύο ή περισσότερες φωτογραφίες της μπροστινής όψης, τραβηγμένες από διαφορετικές κατευθύνσεις.</translation>
    </message>
    <message>
      <source>the length of %1 mm marked on the back side measures %2 +- %3 mm in the photographs (%4 %)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το μήκος %1 mm που σημειώθηκε στην πίσω όψη μετρά %2 ± %3 mm στις φωτογραφίες (%4 %)</translation>
    </message>
    <message>
      <source>The length of %1 mm in scale.json could not be checked: mark each of its ends on at least two photographs of the back side, taken from different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μήκος %1 mm στο scale.json δεν συγκρίθηκε: σημειώστε κάθε άκρο του σε δύο ή περισσότερες φωτογραφίες της πίσω όψης, τραβηγμένες από διαφορετικές κατευθύνσεις.</translation>
    </message>
    <message>
      <source>The folder cannot be read; choose a folder of PLY files.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος δεν διαβάζεται· ονομάστε έναν φάκελο με αρχεία PLY.</translation>
    </message>
    <message>
      <source>This folder contains no PLY files; each sherd&apos;s scan must be one PLY file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει αρχείο PLY σε αυτόν τον φάκελο· η σάρωση κάθε οστράκου πρέπει να είναι ένα αρχείο PLY.</translation>
    </message>
    <message>
      <source>%1: 1 point without finite coordinates was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: 1 σημείο χωρίς πεπερασμένες συντεταγμένες παραλείφθηκε· ελέγξτε την εξαγωγή.</translation>
    </message>
    <message>
      <source>%1: %2 points without finite coordinates were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 σημεία χωρίς πεπερασμένες συντεταγμένες παραλείφθηκαν· ελέγξτε την εξαγωγή.</translation>
    </message>
    <message>
      <source>%1: 1 point far from all others, or at 0, 0, 0, was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: 1 σημείο μακριά από όλα τα άλλα, ή στο 0, 0, 0, παραλείφθηκε· ελέγξτε την εξαγωγή.</translation>
    </message>
    <message>
      <source>%1: %2 points far from all others, or at 0, 0, 0, were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 σημεία μακριά από όλα τα άλλα, ή στο 0, 0, 0, παραλείφθηκαν· ελέγξτε την εξαγωγή.</translation>
    </message>
    <message>
      <source>The scan has fewer than 100 points; rescan this side.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση έχει λιγότερα από 100 σημεία· σαρώστε ξανά αυτή την όψη.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with nx, ny and nz.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση δεν έχει κάθετα διανύσματα· εξαγάγετέ την με nx, ny και nz.</translation>
    </message>
    <message>
      <source>The scan is %1 times its length away from the origin, so its coordinates are rounded; move it to the origin and export it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση απέχει %1 φορές το μήκος της από το 0, 0, 0, οπότε οι συντεταγμένες της στρογγυλεύονται· μετακινήστε την εκεί και εξαγάγετέ την ξανά.</translation>
    </message>
    <message>
      <source>None of the scans can be used: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία από τις σαρώσεις δεν χρησιμοποιείται: %1</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; their unit seems to be %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτές οι σαρώσεις έχουν διάμεσο μήκος %1 mm· μοιάζουν με %2: %3.</translation>
    </message>
    <message>
      <source>The median length of these scans is %1 mm; no sherds are of that size: %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτές οι σαρώσεις έχουν διάμεσο μήκος %1 mm· δεν υπάρχουν όστρακα τέτοιου μεγέθους: %2.</translation>
    </message>
    <message>
      <source>The median length of the fronts is %1 mm, of the backs %2 mm, so their units differ: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι μπροστινές όψεις έχουν διάμεσο μήκος %1 mm, οι πίσω %2 mm, οπότε οι μονάδες τους διαφέρουν: %3.</translation>
    </message>
    <message>
      <source>centimetres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εκατοστά</translation>
    </message>
    <message>
      <source>metres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μέτρα</translation>
    </message>
    <message>
      <source>micrometres</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μικρόμετρα</translation>
    </message>
    <message>
      <source>export them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εξαγάγετέ τις σε mm</translation>
    </message>
    <message>
      <source>export them in mm, or use --scale free</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>εξαγάγετέ τις σε mm, ή χρησιμοποιήστε --scale free</translation>
    </message>
    <message>
      <source>Sherd %1 has no model: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο %1 δεν έχει μοντέλο: %2</translation>
    </message>
    <message>
      <source>Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in its picture; reshoot it if that matters.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1: το %2 % της επιφάνειάς του δεν το είδε καμία κάμερα και έχει συμπληρωθεί, πορτοκαλί στην εικόνα· φωτογραφίστε το ξανά, αν έχει σημασία.</translation>
    </message>
    <message>
      <source>Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, the photographs do not show that area; reshoot the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακο %1: το μοντέλο του έχει μια διαμπερή οπή (%2 mm²). Αν το όστρακο δεν έχει καμία, οι φωτογραφίες δεν δείχνουν αυτό το σημείο· φωτογραφίστε το ξανά.</translation>
    </message>
    <message>
      <source>The file lists %1, which is not in the batch; delete the file to find the cameras again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ονομάζει το %1, που δεν είναι στην παρτίδα· διαγράψτε αυτό το αρχείο, και οι κάμερες θα βρεθούν ξανά.</translation>
    </message>
    <message>
      <source>This photograph has no mask; provide one for each photograph to be used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία δεν έχει μάσκα· δώστε μία για καθεμία που θα χρησιμοποιηθεί.</translation>
    </message>
    <message>
      <source>This photograph is not used.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία δεν χρησιμοποιείται.</translation>
    </message>
    <message>
      <source>Photographs of the front side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της μπροστινής όψης που παραλείπονται, επειδή το COLMAP δεν βρήκε την πόζα τους: %1.</translation>
    </message>
    <message>
      <source>Photographs of the back side that are left out because COLMAP found no pose for them: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της πίσω όψης που παραλείπονται, επειδή το COLMAP δεν βρήκε την πόζα τους: %1.</translation>
    </message>
    <message>
      <source>The rig was not used: without plate.json the poses come from COLMAP.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη δεν χρησιμοποιήθηκε: χωρίς plate.json οι θέσεις έρχονται από το COLMAP.</translation>
    </message>
    <message>
      <source>%1: The mask marks no sherd in this photograph; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Η μάσκα δεν σημειώνει κανένα όστρακο σε αυτή τη φωτογραφία· παραλείπεται.</translation>
    </message>
    <message>
      <source>If it shows sherds, retake it or edit its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αν έχει όστρακα, τραβήξτε την ξανά ή διορθώστε τη μάσκα της.</translation>
    </message>
    <message>
      <source>Photographs of the front side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της μπροστινής όψης των οποίων οι μάσκες δείχνουν όστρακα: %1· χρειάζονται τουλάχιστον 3.</translation>
    </message>
    <message>
      <source>Photographs of the back side whose masks mark sherds: %1; at least 3 are needed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της πίσω όψης των οποίων οι μάσκες δείχνουν όστρακα: %1· χρειάζονται τουλάχιστον 3.</translation>
    </message>
    <message>
      <source>Check the masks, and whether sherds were on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δείτε τις μάσκες, και αν υπήρχαν όστρακα πάνω στον δίσκο.</translation>
    </message>
    <message>
      <source>Fewer than 10 fracture points match; start from a better pose.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λιγότερα από 10 σημεία των θραύσεων ταιριάζουν· ξεκινήστε από καλύτερη θέση.</translation>
    </message>
    <message>
      <source>No photograph shows the sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία φωτογραφία δεν δείχνει το όστρακο.</translation>
    </message>
    <message>
      <source>Not every vertex has a place in the texture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν έχουν όλες οι κορυφές θέση στην υφή.</translation>
    </message>
    <message>
      <source>The texture of this GLB model cannot be read, so the model is used without it; reprocess its batch to write the file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η υφή αυτού του μοντέλου GLB δεν διαβάζεται, οπότε το μοντέλο χρησιμοποιείται χωρίς αυτήν· επεξεργαστείτε ξανά την παρτίδα του για να γραφτεί εκ νέου το αρχείο.</translation>
    </message>
    <message>
      <source>The texture of this model has more than 67,108,864 pixels, so the model is used without it; export the model with a smaller one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η υφή αυτού του μοντέλου έχει πάνω από 67.108.864 εικονοστοιχεία, οπότε το μοντέλο χρησιμοποιείται χωρίς αυτήν· εξαγάγετε το μοντέλο με μικρότερη υφή.</translation>
    </message>
    <message>
      <source>The texture of sherd %1 lacks a photograph: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από την υφή του οστράκου %1 λείπει μια φωτογραφία: %2</translation>
    </message>
    <message>
      <source>Sherd %1 has no photographic texture: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο %1 δεν έχει φωτογραφική υφή: %2</translation>
    </message>
    <message>
      <source>The colour chart is overexposed or underexposed (clipped patches: %1), so it is not used and colours stay as photographed; reshoot it at another exposure.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χρωματικός πίνακας είναι υπερεκτεθειμένος ή υποεκτεθειμένος (κορεσμένα πεδία: %1)· δεν χρησιμοποιείται και τα χρώματα μένουν όπως φωτογραφήθηκαν· φωτογραφίστε τον ξανά με άλλη έκθεση.</translation>
    </message>
    <message>
      <source>The colour chart is shaded, bent or partly hidden, so it is not used and colours stay as photographed; reshoot it flat, whole and evenly lit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χρωματικός πίνακας είναι σκιασμένος, λυγισμένος ή εν μέρει καλυμμένος· δεν χρησιμοποιείται και τα χρώματα μένουν όπως φωτογραφήθηκαν· φωτογραφίστε τον ξανά επίπεδο, ολόκληρο και ομοιόμορφα φωτισμένο.</translation>
    </message>
    <message>
      <source>colours: corrected by the colour chart in %1 photographs; its patches differ from their reference by %2 (median) and %3 (95 %), CIEDE2000</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>χρώματα: διορθώθηκαν με τον χρωματικό πίνακα σε %1 φωτογραφίες· τα πεδία του διαφέρουν από τις τιμές αναφοράς κατά %2 (διάμεσος) και %3 (95 %), CIEDE2000</translation>
    </message>
    <message>
      <source>The chosen registration method did not converge; use the default method, or align the back by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επιλεγμένη μέθοδος ένωσης δεν συνέκλινε· χρησιμοποιήστε την προεπιλεγμένη μέθοδο ή ευθυγραμμίστε την πίσω πλευρά με το χέρι.</translation>
    </message>
    <message>
      <source>Too few fracture points for the chosen registration method; use the default method.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πολύ λίγα σημεία θραύσης για την επιλεγμένη μέθοδο ένωσης· χρησιμοποιήστε την προεπιλεγμένη μέθοδο.</translation>
    </message>
    <message>
      <source>No start pose was given for the registration.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε αρχική θέση για την ένωση των όψεων.</translation>
    </message>
    <message>
      <source>The scan has no normals; export it with normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σάρωση δεν έχει κάθετα διανύσματα· εξαγάγετέ την με αυτά.</translation>
    </message>
    <message>
      <source>Fewer than 50 points are on the fracture; rescan the sherd including its fracture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λιγότερα από 50 σημεία βρίσκονται στη θραύση· σαρώστε ξανά το όστρακο μαζί με τη θραύση του.</translation>
    </message>
    <message>
      <source>%1: The board was not detected; this picture is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: Ο πίνακας βαθμονόμησης δεν φαίνεται· αυτή η εικόνα παραλείπεται.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το λεξικό %1 έχει πολύ λίγους δείκτες για τον πίνακα βαθμονόμησης.</translation>
    </message>
    <message>
      <source>A grid of markers needs 'dictionary', 'markers_x', 'markers_y', 'marker_length' and 'marker_separation'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα πλέγμα δεικτών χρειάζεται 'dictionary', 'markers_x', 'markers_y', 'marker_length' και 'marker_separation'.</translation>
    </message>
    <message>
      <source>Nothing to calibrate from: put photographs of the plate at each position into &apos;front&apos; (cam0_pos00.jpg and so on) and pictures of the board into &apos;calib&apos;, and copy plate.json and board.json next to them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει τίποτα για βαθμονόμηση: φωτογραφίστε τον δίσκο σε κάθε στάση στο 'front' (cam0_pos00.jpg και ούτω καθεξής) και τον πίνακα βαθμονόμησης στο 'calib', και αντιγράψτε δίπλα τους τα plate.json και board.json.</translation>
    </message>
    <message>
      <source>No pictures of the board found; put them here or into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχουν εικόνες του πίνακα βαθμονόμησης· βάλτε τες εδώ ή στο 'calib'.</translation>
    </message>
    <message>
      <source>It is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπαίνει στην άκρη.</translation>
    </message>
    <message>
      <source>%1: its size differs from that of the first picture; it is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: το μέγεθός της δεν είναι ίδιο με της πρώτης· μπαίνει στην άκρη.</translation>
    </message>
    <message>
      <source>The bundle adjustment of the rig did not converge; check that plate.json and board.json describe what was photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η προσαρμογή της διάταξης δεν συνέκλινε· ελέγξτε ότι τα plate.json και board.json περιγράφουν ό,τι φωτογραφήθηκε.</translation>
    </message>
    <message>
      <source>The file does not describe how the sheets bend; delete it to measure them again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν λέει πώς είναι λυγισμένα τα φύλλα· διαγράψτε το αρχείο και θα μετρηθούν ξανά.</translation>
    </message>
    <message>
      <source>The file does not describe what the sherds stand on; delete it to determine this again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν λέει πάνω σε τι στέκονται τα όστρακα· διαγράψτε το και θα βρεθεί ξανά.</translation>
    </message>
    <message>
      <source>The sheet's markers can be read in %1 of %2 photographs of the %3 side; at least 3 are needed. Check that plate.json describes this sheet, that the photographs are not mirrored, and that most of the markers are in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δείκτες του φύλλου διαβάζονται σε %1 από %2 φωτογραφίες της όψης %3· χρειάζονται τουλάχιστον 3. Ελέγξτε ότι το plate.json περιγράφει αυτό το φύλλο, ότι οι φωτογραφίες δεν είναι ανεστραμμένες και ότι οι περισσότεροι δείκτες είναι μέσα στην εικόνα.</translation>
    </message>
    <message>
      <source>%1: %2 of the sheet&apos;s markers can be read, too few for a pose; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: διαβάζονται %2 δείκτες του φύλλου, πολύ λίγοι για θέση· παραλείπεται.</translation>
    </message>
    <message>
      <source>Photographs that show too few of the sheet&apos;s markers for a pose are left out (%1 and %2 more); check that they show this sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παραλείπονται φωτογραφίες που δείχνουν πολύ λίγους δείκτες του φύλλου για μια θέση (%1 και %2 ακόμη)· δείτε αν δείχνουν αυτό το φύλλο.</translation>
    </message>
    <message>
      <source>%1: most of the sheet&apos;s markers are not where the other photographs place them; the photograph is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: οι περισσότεροι δείκτες του φύλλου βρίσκονται εκεί σε άλλη θέση από ό,τι δείχνουν οι άλλες φωτογραφίες· παραλείπεται.</translation>
    </message>
    <message>
      <source>Only one side was photographed: its %1 scans are open surfaces without a back; they are in 'unpaired'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφήθηκε μόνο μία όψη: οι %1 σαρώσεις της είναι ανοιχτές επιφάνειες χωρίς πίσω όψη· βρίσκονται στο 'unpaired'.</translation>
    </message>
    <message>
      <source>plate.json is missing, so the plate&apos;s markers cannot be used; copy the file that &apos;ostraka plate&apos; wrote with the plate into this folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει plate.json, οπότε οι δείκτες του δίσκου δεν χρησιμοποιούνται· αντιγράψτε εδώ εκείνο που έγραψε το 'ostraka plate' μαζί με τον δίσκο.</translation>
    </message>
    <message>
      <source>The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is calibrated from this batch instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γνωστή διάταξη δεν έχει κάμερα %1 με εικόνες %2 x %3 εικονοστοιχείων· βαθμονομείται από αυτή την παρτίδα.</translation>
    </message>
    <message>
      <source>Its lens is estimated from the plate's markers instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φακός της εκτιμάται από τους δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>The lens of camera %1 is unknown: no usable pictures of the board and no plate markers were found; add pictures of the board to &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φακός της κάμερας %1 δεν είναι γνωστός: δεν υπάρχουν ούτε χρήσιμες εικόνες του πίνακα βαθμονόμησης ούτε δείκτες του δίσκου· προσθέστε εικόνες του πίνακα βαθμονόμησης στο 'calib'.</translation>
    </message>
    <message>
      <source>The lens of camera %1 was estimated from the plate&apos;s markers alone; add 12 pictures of the board to &apos;calib&apos; for accurate measurements.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φακός της κάμερας %1 εκτιμήθηκε μόνο από τους δείκτες του δίσκου· για ακριβή μέτρα προσθέστε 12 εικόνες του πίνακα βαθμονόμησης στο 'calib'.</translation>
    </message>
    <message>
      <source>The plate's markers were found in %1 of %2 photographs, too few for a pose of each side; check that plate.json belongs to this plate and that the markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δείκτες του δίσκου βρέθηκαν σε %1 από %2 φωτογραφίες, πολύ λίγες για τη θέση κάθε όψης· ελέγξτε ότι το plate.json ανήκει σε αυτόν τον δίσκο και ότι οι δείκτες φωτίζονται και είναι μέσα στην εικόνα.</translation>
    </message>
    <message>
      <source>No photograph of camera %1 shows two markers of the plate; all its photographs are left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία φωτογραφία της κάμερας %1 δεν δείχνει δύο δείκτες του δίσκου· όλες οι φωτογραφίες της παραλείπονται.</translation>
    </message>
    <message>
      <source>The known rig no longer fits: camera %1 misses the markers by %2 px. The camera poses are re-estimated for this batch; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η γνωστή διάταξη δεν ταιριάζει πια: η κάμερα %1 χάνει τους δείκτες κατά %2 px· οι θέσεις των καμερών εκτιμώνται εκ νέου για αυτή την παρτίδα, βαθμονομήστε ξανά τη διάταξη.</translation>
    </message>
    <message>
      <source>%1: none of its %2 markers is where this camera sees them at this position.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: κανένας από τους %2 δείκτες της δεν βρίσκεται εκεί όπου τους βλέπει αυτή η κάμερα σε αυτή τη στάση.</translation>
    </message>
    <message>
      <source>It has another photograph&apos;s name or was taken while the plate was turning; it is left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Έχει το όνομα άλλης φωτογραφίας ή τραβήχτηκε ενώ ο δίσκος γύριζε· παραλείπεται.</translation>
    </message>
    <message>
      <source>%1: no marker is visible; check that the photograph shows this position. If not, retake it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: δεν φαίνεται κανένας δείκτης· ελέγξτε ότι η φωτογραφία δείχνει αυτή τη στάση. Αν όχι, τραβήξτε την ξανά.</translation>
    </message>
    <message>
      <source>Photographs of the front side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της μπροστινής όψης με γνωστή πόζα: %1· χρειάζονται τουλάχιστον 3. Ελέγξτε ότι οι δείκτες του δίσκου φωτίζονται και φαίνονται στην εικόνα.</translation>
    </message>
    <message>
      <source>Photographs of the back side with a pose: %1; at least 3 are needed. Check that the plate&apos;s markers are lit and in the picture.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της πίσω όψης με γνωστή πόζα: %1· χρειάζονται τουλάχιστον 3. Ελέγξτε ότι οι δείκτες του δίσκου φωτίζονται και φαίνονται στην εικόνα.</translation>
    </message>
    <message>
      <source>Camera %1 sees fewer than six of the plate&apos;s markers at position %2; check lighting and focus there and that nothing covers the markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 βλέπει λιγότερους από έξι δείκτες του δίσκου στη στάση %2· ελέγξτε εκεί φως και εστίαση, και ότι τίποτα δεν είναι πάνω στους δείκτες.</translation>
    </message>
    <message>
      <source>Positions photographed: %1; photograph at least four around the full turn to determine the axis.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στάσεις που φωτογραφήθηκαν: %1· φωτογραφίστε τουλάχιστον τέσσερις σε όλη την περιστροφή, για να προσδιοριστεί ο άξονας.</translation>
    </message>
    <message>
      <source>Fewer than eight markers were detected, so no distance could be held out of the fit: the scale is not checked.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάνηκαν λιγότεροι από οκτώ δείκτες, οπότε καμία απόσταση δεν κρατήθηκε για έλεγχο: η κλίμακα δεν ελέγχθηκε.</translation>
    </message>
    <message>
      <source>Markers %1 and %2: you measured %3 mm, plate.json says %4 mm (%5 %); measure the plate&apos;s ruler and regenerate plate.json with &apos;ostraka plate --ruler-measured&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανάμεσα στους δείκτες %1 και %2 μετρήσατε %3 mm, κατά το plate.json είναι %4 mm (%5 %)· μετρήστε τον χάρακα του δίσκου και φτιάξτε ξανά το plate.json με 'ostraka plate --ruler-measured'.</translation>
    </message>
    <message>
      <source>Not usable: camera %1 misses the plate&apos;s markers by a median of %2 px; check that it did not move between the photographs and that plate.json belongs to this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μη χρησιμοποιήσιμη: η κάμερα %1 χάνει τους δείκτες του δίσκου κατά %2 px (διάμεσος)· μήπως αγγίχτηκε ανάμεσα στις φωτογραφίες, ή το plate.json είναι άλλου δίσκου;</translation>
    </message>
    <message>
      <source>Not usable: the scale is wrong.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μη χρησιμοποιήσιμη: η κλίμακα δεν είναι σωστή.</translation>
    </message>
    <message>
      <source>Good: lenses, camera poses and scale are determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καλή: φακοί, θέσεις και κλίμακα είναι καθορισμένα.</translation>
    </message>
    <message>
      <source>Usable for a trial only: the lens of camera %1 comes from the plate&apos;s markers alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμη μόνο για δοκιμή: ο φακός της κάμερας %1 προκύπτει μόνο από τους δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>Usable, but a focal length is uncertain by more than a thousandth.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμη, αλλά μια εστιακή απόσταση δεν είναι γνωστή καλύτερα από ένα χιλιοστό της τιμής της.</translation>
    </message>
    <message>
      <source>Usable; the steps below improve it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμη· όσα αναφέρονται παρακάτω θα τη βελτίωναν.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: εστιακή απόσταση %2 px (%3 %).</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: εστιακή απόσταση %2 px (%3 %), %4 εικόνες του πίνακα βαθμονόμησης με %5 px, χειρότερη η %6 με %7 px, κλίση ως %8 μοίρες.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), median error at the plate&apos;s markers %4 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: εστιακή απόσταση %2 px (%3 %), οι δείκτες του δίσκου με διάμεσο %4 px.</translation>
    </message>
    <message>
      <source>Camera %1: focal length %2 px (%3 %), %4 pictures of the board with %5 px, worst %6 with %7 px, tilted up to %8 degrees, median error at the plate&apos;s markers %9 px.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: εστιακή απόσταση %2 px (%3 %), %4 εικόνες του πίνακα βαθμονόμησης με %5 px, χειρότερη η %6 με %7 px, κλίση ως %8 μοίρες, οι δείκτες του δίσκου με διάμεσο %9 px.</translation>
    </message>
    <message>
      <source>Camera %1: take 12 pictures of the board, near and far, in all corners of the picture, tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: τραβήξτε 12 εικόνες του πίνακα βαθμονόμησης, από κοντά και από μακριά, σε όλες τις γωνίες της εικόνας, με κλίση 20 έως 45 μοιρών προς διαφορετικές κατευθύνσεις.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: μόνο 1 εικόνα δείχνει τον πίνακα βαθμονόμησης· τραβήξτε τουλάχιστον 8, καλύτερα 12.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board; take at least 8, preferably 12.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: μόνο %2 εικόνες δείχνουν τον πίνακα βαθμονόμησης· τραβήξτε τουλάχιστον 8, καλύτερα 12.</translation>
    </message>
    <message>
      <source>Camera %1: the board barely reaches the %2 of the picture; add pictures with the board there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: ο πίνακας βαθμονόμησης μόλις φτάνει σε αυτά τα μέρη της εικόνας: %2· προσθέστε εικόνες με τον πίνακα βαθμονόμησης εκεί.</translation>
    </message>
    <message>
      <source>upper left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάνω αριστερά</translation>
    </message>
    <message>
      <source>upper middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάνω στη μέση</translation>
    </message>
    <message>
      <source>upper right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πάνω δεξιά</translation>
    </message>
    <message>
      <source>left middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στη μέση αριστερά</translation>
    </message>
    <message>
      <source>middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στη μέση</translation>
    </message>
    <message>
      <source>right middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στη μέση δεξιά</translation>
    </message>
    <message>
      <source>lower left</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάτω αριστερά</translation>
    </message>
    <message>
      <source>lower middle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάτω στη μέση</translation>
    </message>
    <message>
      <source>lower right</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>κάτω δεξιά</translation>
    </message>
    <message>
      <source>Camera %1: no picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: καμία εικόνα δεν δείχνει τον πίνακα βαθμονόμησης με κλίση πάνω από 20 μοίρες· τραβήξτε τουλάχιστον τέσσερις, με κλίση προς διαφορετικές πλευρές.</translation>
    </message>
    <message>
      <source>Camera %1: only 1 picture shows the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: μόνο 1 εικόνα δείχνει τον πίνακα βαθμονόμησης με κλίση πάνω από 20 μοίρες· τραβήξτε τουλάχιστον τέσσερις, με κλίση προς διαφορετικές πλευρές.</translation>
    </message>
    <message>
      <source>Camera %1: only %2 pictures show the board tilted by more than 20 degrees; take at least four, tilted to different sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: μόνο %2 εικόνες δείχνουν τον πίνακα βαθμονόμησης με κλίση πάνω από 20 μοίρες· τραβήξτε τουλάχιστον τέσσερις, με κλίση προς διαφορετικές πλευρές.</translation>
    </message>
    <message>
      <source>Reprojection error %1 px over the plate's markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σφάλμα επαναπροβολής %1 px στους δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: οι δείκτες %1 και %2, που κρατήθηκαν για έλεγχο, απέχουν %3 mm αντί για %4 (%5 mm, %6 %).</translation>
    </message>
    <message>
      <source>Scale: markers %1 and %2, measured by hand as %3 mm between the midpoints of their outer edges, are %4 mm apart in the photographs (%5 %).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: οι δείκτες %1 και %2, με το χέρι %3 mm ανάμεσα στα μέσα των εξωτερικών πλευρών τους, απέχουν %4 mm στις φωτογραφίες (%5 %).</translation>
    </message>
    <message>
      <source>Set aside: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στην άκρη: %1</translation>
    </message>
    <message>
      <source>The lens is known but the camera poses are not, so no rig can be saved.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φακός είναι γνωστός, οι θέσεις των καμερών όχι: δεν μπορεί να αποθηκευτεί διάταξη.</translation>
    </message>
    <message>
      <source>Not usable: the focal length is not determined.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μη χρησιμοποιήσιμη: η εστιακή απόσταση δεν καθορίστηκε.</translation>
    </message>
    <message>
      <source>Photograph the plate with its markers too: put one picture per camera and position into &apos;front&apos; (cam0_pos00.jpg and so on) next to plate.json, and the board&apos;s pictures into &apos;calib&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίστε και τον δίσκο με τους δείκτες του: βάλτε μία εικόνα ανά κάμερα και στάση στο 'front' (cam0_pos00.jpg και ούτω καθεξής) δίπλα στο plate.json, τις εικόνες του πίνακα βαθμονόμησης στο 'calib'.</translation>
    </message>
    <message>
      <source>Marker %1 of the known length is visible in fewer than two photographs; choose two markers of the plate that the photographs show.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δείκτης %1 του γνωστού μήκους δεν φαίνεται δύο φορές· ονομάστε δύο δείκτες του δίσκου που δείχνουν οι φωτογραφίες.</translation>
    </message>
    <message>
      <source>A known length needs two different markers and a value greater than 0 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα γνωστό μήκος χρειάζεται δύο διαφορετικούς δείκτες και χιλιοστά πάνω από το μηδέν.</translation>
    </message>
    <message>
      <source>Folder not found; choose one with photographs of the plate or of the board.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει τέτοιος φάκελος· ονομάστε έναν με φωτογραφίες του δίσκου ή του πίνακα βαθμονόμησης.</translation>
    </message>
    <message>
      <source>The lens %1 is not known; it is 'standard' or 'fisheye'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φακός %1 δεν είναι γνωστός· είναι 'standard' ή 'fisheye'.</translation>
    </message>
    <message>
      <source>Numbers in 'dist': %1; a lens has 0, 4, 5, 8 or 12 in OpenCV's order, a fisheye has 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αριθμοί στο 'dist': %1· ένας φακός έχει 0, 4, 5, 8 ή 12 με τη σειρά του OpenCV, ένας φακός fisheye έχει 4.</translation>
    </message>
    <message>
      <source>No lens has the numbers in 'dist': its picture folds near the middle. Check their order.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κανένας φακός δεν έχει τους αριθμούς του 'dist': η εικόνα του διπλώνει κοντά στο κέντρο. Ελέγξτε τη σειρά τους.</translation>
    </message>
    <message>
      <source>The camera of '%1' has no valid K, R, t or size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα του '%1' δεν έχει έγκυρο K, R, t ή μέγεθος.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από μια εικόνα λείπει file, width, height, K, R ή t.</translation>
    </message>
    <message>
      <source>An image lacks file, width, height, K, R or t (%1).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από μια εικόνα λείπει file, width, height, K, R ή t (%1).</translation>
    </message>
    <message>
      <source>The camera file has no list &apos;images&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο των καμερών δεν περιέχει λίστα 'images'.</translation>
    </message>
    <message>
      <source>COLMAP&apos;s camera %1 has the model &apos;%2&apos; or values that Ostraka does not support; use the model OPENCV instead.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 του COLMAP έχει το μοντέλο '%2' ή τιμές που δεν χρησιμοποιούνται εδώ· χρησιμοποιήστε OPENCV.</translation>
    </message>
    <message>
      <source>COLMAP's model has no camera for the image '%1'.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μοντέλο του COLMAP δεν έχει κάμερα για την εικόνα '%1'.</translation>
    </message>
    <message>
      <source>The file is damaged or not in COLMAP&apos;s format; run COLMAP again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο έχει βλάβη ή δεν είναι όπως το γράφει το COLMAP· εκτελέστε ξανά το COLMAP.</translation>
    </message>
    <message>
      <source>The pose of this photograph is estimated without its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η θέση αυτής της φωτογραφίας προσδιορίζεται χωρίς τη μάσκα της.</translation>
    </message>
    <message>
      <source>Without plate.json, poses come from COLMAP, which is not installed; install the package &apos;colmap&apos; or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χωρίς plate.json οι θέσεις έρχονται από το COLMAP, που δεν είναι εγκατεστημένο· εγκαταστήστε το πακέτο 'colmap' ή φωτογραφίστε πάνω σε δίσκο με δείκτες.</translation>
    </message>
    <message>
      <source>COLMAP found poses for %1 of %2 photographs, too few; provide masks or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το COLMAP βρήκε θέση για %1 από %2 φωτογραφίες, πολύ λίγες· δώστε μάσκες ή φωτογραφίστε πάνω σε δίσκο με δείκτες.</translation>
    </message>
    <message>
      <source>The scale is wrong: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, %6 %); check that plate.json belongs to this plate, that the plate is printed and glued without distortion, and that a known rig was calibrated with it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κλίμακα δεν είναι σωστή: οι δείκτες %1 και %2, που κρατήθηκαν για έλεγχο, απέχουν %3 mm αντί για %4 (%5 mm, %6 %)· ελέγξτε ότι το plate.json ανήκει σε αυτόν τον δίσκο, ότι ο δίσκος είναι σωστά τυπωμένος και κολλημένος, και ότι η γνωστή διάταξη βαθμονομήθηκε με αυτόν.</translation>
    </message>
    <message>
      <source>Relative to camera %1, camera %2 has moved by %3 mm and turned by %4 degrees since the rig was calibrated.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε σχέση με την κάμερα %1, η κάμερα %2 μετακινήθηκε κατά %3 mm και στράφηκε κατά %4 μοίρες από τη βαθμονόμηση της διάταξης.</translation>
    </message>
    <message>
      <source>%1: the board was not detected; the picture is set aside.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: ο πίνακας βαθμονόμησης δεν φαίνεται σε αυτήν· μπαίνει στην άκρη.</translation>
    </message>
    <message>
      <source>The marker dictionary &apos;%1&apos; is unknown; use one such as DICT_4X4_100.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το λεξικό δεικτών '%1' δεν είναι γνωστό· χρησιμοποιήστε ένα όπως το DICT_4X4_100.</translation>
    </message>
    <message>
      <source>The markers&apos; side must be between 5 and 200 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πλευρά των δεικτών πρέπει να είναι μεταξύ 5 και 200 mm.</translation>
    </message>
    <message>
      <source>The plate&apos;s diameter must be between 1 and 2000 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάμετρος του δίσκου πρέπει να είναι μεταξύ 1 και 2000 mm.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε δίσκο %2 mm χωρούν λιγότεροι από έξι δείκτες %1 mm· χωρούν δείκτες %3 mm.</translation>
    </message>
    <message>
      <source>Fewer than six markers of %1 mm fit on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε δίσκο %2 mm χωρούν λιγότεροι από έξι δείκτες %1 mm· κάντε τον δίσκο μεγαλύτερο.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; markers of %3 mm fit on it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δείκτες %1 mm δεν αφήνουν χώρο για όστρακο σε δίσκο %2 mm· χωρούν δείκτες %3 mm.</translation>
    </message>
    <message>
      <source>Markers of %1 mm leave no room for a sherd on a plate of %2 mm; make the plate larger.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δείκτες %1 mm δεν αφήνουν χώρο για όστρακο σε δίσκο %2 mm· κάντε τον δίσκο μεγαλύτερο.</translation>
    </message>
    <message>
      <source>The printer&apos;s margin must be between 0 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το περιθώριο του εκτυπωτή πρέπει να είναι μεταξύ 0 και 40 mm.</translation>
    </message>
    <message>
      <source>The sheets&apos; overlap must be between 5 and 40 mm.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επικάλυψη των φύλλων πρέπει να είναι μεταξύ 5 και 40 mm.</translation>
    </message>
    <message>
      <source>The dictionary %1 has too few markers for this plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το λεξικό %1 έχει πολύ λίγους δείκτες για αυτόν τον δίσκο.</translation>
    </message>
    <message>
      <source>The measured ruler length must be in mm and within the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όσο μετρά ο χάρακας πρέπει να είναι μήκος σε mm μέσα στον δίσκο.</translation>
    </message>
    <message>
      <source>The ruler of this plate is drawn %1 mm long; %2 mm differs by more than a tenth. Print the file at 100 %, without &apos;fit to page&apos;, and measure again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χάρακας αυτού του δίσκου σχεδιάστηκε με μήκος %1 mm, τα %2 mm διαφέρουν πάνω από ένα δέκατο· τυπώστε το αρχείο στο 100 %, χωρίς 'προσαρμογή στη σελίδα', και μετρήστε ξανά.</translation>
    </message>
    <message>
      <source>Camera %1 has a covariance of the wrong size; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 έχει συνδιακύμανση άλλου μεγέθους· βαθμονομήστε ξανά τη διάταξη.</translation>
    </message>
    <message>
      <source>Another version of Ostraka wrote this rig; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η διάταξη γράφτηκε από άλλη έκδοση· βαθμονομήστε ξανά τη διάταξη.</translation>
    </message>
    <message>
      <source>Camera %1 appears twice in the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 υπάρχει δύο φορές στη διάταξη.</translation>
    </message>
    <message>
      <source>The rig has more than %1 positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη έχει περισσότερες από %1 στάσεις· βαθμονομήστε την ξανά.</translation>
    </message>
    <message>
      <source>Position %1 appears twice in the rig; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η στάση %1 υπάρχει δύο φορές στη διάταξη· βαθμονομήστε την ξανά.</translation>
    </message>
    <message>
      <source>The rig&apos;s lengths are not in mm; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα μήκη της διάταξης δεν είναι σε mm· βαθμονομήστε την ξανά.</translation>
    </message>
    <message>
      <source>Camera %1 has pictures of %2 x %3 pixels, which no camera takes; recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα %1 έχει εικόνες %2 x %3 pixel, που καμία κάμερα δεν βγάζει· βαθμονομήστε ξανά τη διάταξη.</translation>
    </message>
    <message>
      <source>Not a rig file (RIG.json); recalibrate the rig.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό δεν είναι αρχείο διάταξης (RIG.json)· βαθμονομήστε ξανά τη διάταξη.</translation>
    </message>
    <message>
      <source>The rig has no camera; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη δεν έχει κάμερα· βαθμονομήστε την ξανά.</translation>
    </message>
    <message>
      <source>This file already exists and is not a rig; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο υπάρχει ήδη και δεν είναι διάταξη· ονομάστε άλλο.</translation>
    </message>
    <message>
      <source>The log cannot be written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το ημερολόγιο δεν γράφεται.</translation>
    </message>
    <message>
      <source>A process cannot be started.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ξεκινά καμία διεργασία.</translation>
    </message>
    <message>
      <source>The program&apos;s exit status is unknown.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα χάθηκε.</translation>
    </message>
    <message>
      <source>The program cannot be started; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα δεν ξεκινά· εγκαταστήστε το.</translation>
    </message>
    <message>
      <source>%1 ended with an error; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 τελείωσε με σφάλμα· τα μηνύματά του είναι σε αυτό το αρχείο.</translation>
    </message>
    <message>
      <source>A small object of %1 mm at x %2, y %3 mm was left out; if it is a sherd, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα ψίχουλο %1 mm στο x %2, y %3 mm έμεινε στην άκρη· αν είναι όστρακο, φωτογραφίστε το μόνο του.</translation>
    </message>
    <message>
      <source>A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάτι επίπεδο στο x %1, y %2 mm έμεινε στην άκρη· ίσως είναι δείκτης ή βρωμιά πάνω στον δίσκο.</translation>
    </message>
    <message>
      <source>Two sherds touch at x %1, y %2 mm and were split there; leave a finger&apos;s width between sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο όστρακα αγγίζονται στο x %1, y %2 mm και χωρίστηκαν εκεί· αφήνετε απόσταση ενός δακτύλου ανάμεσα στα όστρακα.</translation>
    </message>
    <message>
      <source>The plate&apos;s point cloud has no normals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το νέφος σημείων του δίσκου δεν έχει κάθετα διανύσματα.</translation>
    </message>
    <message>
      <source>No sherd was found on the front side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε όστρακο στη μπροστινή όψη· ελέγξτε τις μάσκες και τις φωτογραφίες της.</translation>
    </message>
    <message>
      <source>No sherd was found on the back side; check its masks and photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε όστρακο στην πίσω όψη· ελέγξτε τις μάσκες και τις φωτογραφίες της.</translation>
    </message>
    <message>
      <source>This COLMAP was built without CUDA, which its dense stereo needs; install one with CUDA, or use --dense builtin, which needs neither.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το colmap χτίστηκε χωρίς CUDA, που το χρειάζεται η πυκνή στερεοσκοπία του· εγκαταστήστε ένα με CUDA, ή χρησιμοποιήστε --dense builtin, που δεν χρειάζεται τίποτα.</translation>
    </message>
    <message>
      <source>The masks of the views show no common object; check masks, cameras and bounds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι μάσκες των λήψεων δεν έχουν κοινό αντικείμενο· ελέγξτε μάσκες, κάμερες και όρια.</translation>
    </message>
    <message>
      <source>InterfaceCOLMAP wrote no scene; its output is in this file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το InterfaceCOLMAP δεν άφησε σκηνή· τα μηνύματά του είναι σε αυτό το αρχείο.</translation>
    </message>
    <message>
      <source>Stereo needs at least 3 photographs with known cameras.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το βάθος χρειάζεται τουλάχιστον 3 φωτογραφίες με γνωστές κάμερες.</translation>
    </message>
    <message>
      <source>The photograph or its mask differs in size from its camera&apos;s images; use photographs of the size that the camera was calibrated with.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία ή η μάσκα της έχει άλλο μέγεθος από αυτό της κάμερας· δώστε τη φωτογραφία με την οποία βαθμονομήθηκε η κάμερα.</translation>
    </message>
    <message>
      <source>The photograph differs in size from the images that its camera was calibrated with; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία έχει άλλο μέγεθος από αυτό της κάμερας· δώστε τη φωτογραφία με την οποία βαθμονομήθηκε η κάμερα.</translation>
    </message>
    <message>
      <source>The mask and its photograph differ in size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μάσκα έχει άλλο μέγεθος από τη φωτογραφία της.</translation>
    </message>
    <message>
      <source>%1 found no points of the object; its output is in this file, and --dense builtin needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 δεν βρήκε σημεία του αντικειμένου· τα μηνύματά του είναι σε αυτό το αρχείο, και το --dense builtin δεν χρειάζεται άλλο πρόγραμμα.</translation>
    </message>
    <message>
      <source>%1 wrote points without normals; install a newer version, or use --dense builtin.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 έγραψε σημεία χωρίς κάθετα διανύσματα· εγκαταστήστε νεότερη έκδοση, ή χρησιμοποιήστε --dense builtin.</translation>
    </message>
    <message>
      <source>The program %1 is not on the PATH, but --dense %2 needs it; install it, or use --dense builtin, which needs no other program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα %1 δεν είναι στο PATH, αλλά το --dense %2 το χρειάζεται· εγκαταστήστε το, ή χρησιμοποιήστε --dense builtin, που δεν χρειάζεται τίποτα.</translation>
    </message>
    <message>
      <source>No two views agree on any surface point; check cameras and masks.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε σημείο της επιφάνειας στο οποίο συμφωνούν δύο λήψεις· ελέγξτε κάμερες και μάσκες.</translation>
    </message>
    <message>
      <source>The %1 sherds do not fit on the plate; use fewer, or another seed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα %1 όστρακα δεν χωρούν στον δίσκο· ζητήστε λιγότερα, ή άλλον αρχικό αριθμό.</translation>
    </message>
    <message>
      <source>sherds must be between 1 and 40.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός των οστράκων πρέπει να είναι μεταξύ 1 και 40.</translation>
    </message>
    <message>
      <source>width must be between 160 and 8192 pixels and divisible by 4.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πλάτος πρέπει να είναι μεταξύ 160 και 8192 εικονοστοιχείων και να διαιρείται με το 4.</translation>
    </message>
    <message>
      <source>near_duplicates are groups of two: at most half the number of sherds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όμοια όστρακα είναι ομάδες των δύο: το πολύ ο μισός αριθμός των οστράκων.</translation>
    </message>
    <message>
      <source>The rig needs a camera and at least four positions; recalibrate it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διάταξη χρειάζεται μία κάμερα και τουλάχιστον τέσσερις στάσεις· βαθμονομήστε την ξανά.</translation>
    </message>
    <message>
      <source>The virtual camera has no setting %1 of %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εικονική κάμερα δεν έχει ρύθμιση %1 με τιμή %2.</translation>
    </message>
    <message>
      <source>The camera has taken no photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κάμερα δεν τράβηξε φωτογραφία.</translation>
    </message>
    <message>
      <source>COLMAP cannot align these photographs; its output is in this file. Check that all show the same sherds with large overlap, or photograph on a marker plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το COLMAP δεν μπορεί να ευθυγραμμίσει αυτές τις φωτογραφίες· η έξοδός του βρίσκεται σε αυτό το αρχείο. Ελέγξτε ότι όλες δείχνουν τα ίδια όστρακα με μεγάλη επικάλυψη, ή φωτογραφίστε σε δίσκο με δείκτες.</translation>
    </message>
    <message>
      <source>This model is missing; reprocess its batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το μοντέλο λείπει· επανεπεξεργαστείτε την παρτίδα του.</translation>
    </message>
    <message>
      <source>This sherd is void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο αυτό είναι άκυρο.</translation>
    </message>
    <message>
      <source>This sherd is void; reason: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο αυτό είναι άκυρο, επειδή: %1</translation>
    </message>
    <message>
      <source>%1 is void and was left out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 είναι άκυρο και παραλείφθηκε.</translation>
    </message>
    <message>
      <source>The edge taken as the lip barely resembles one (%1 %); check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό που θεωρήθηκε χείλος μόλις που του μοιάζει (%1 %)· ελέγξτε πώς στέκεται το όστρακο.</translation>
    </message>
    <message>
      <source>Ø %1 cm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm</translation>
    </message>
    <message>
      <source>Ø %1 cm (95 %: %2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ø %1 cm (95 %: %2 έως %3)</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σώζεται το %1 % του χείλους</translation>
    </message>
    <message>
      <source>%1 % of the rim preserved (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>σώζεται το %1 % του χείλους (%2 έως %3)</translation>
    </message>
    <message>
      <source>wall %1 mm (%2 to %3)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τοίχωμα %1 mm (%2 έως %3)</translation>
    </message>
    <message>
      <source>wall %1 mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τοίχωμα %1 mm</translation>
    </message>
    <message>
      <source>A bag belongs to a context; enter the context first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια σακούλα ανήκει σε πλαίσιο· καταχωρίστε πρώτα το πλαίσιο.</translation>
    </message>
    <message>
      <source>Context %1 has no bag %2; change or clear the bag at the same time.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πλαίσιο %1 δεν έχει σακούλα %2· αλλάξτε ή αδειάστε συγχρόνως τη σακούλα.</translation>
    </message>
    <message>
      <source>There is no bag %1 in context %2 yet; enter it during capture or import a table of contexts that contains it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν υπάρχει ακόμη σακούλα %1 στο πλαίσιο %2· πληκτρολογήστε την στη λήψη ή εισαγάγετε έναν πίνακα πλαισίων που την περιέχει.</translation>
    </message>
    <message>
      <source>The edge taken as the lip may be a fracture (%1 % that it is the lip), and the diameter may be wrong; check the sherd&apos;s orientation.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό που θεωρήθηκε χείλος μπορεί να είναι θραύση (%1 % ότι είναι το χείλος) και η διάμετρος λάθος· ελέγξτε πώς στέκεται το όστρακο.</translation>
    </message>
    <message>
      <source>This batch is still being photographed; it is processed afterwards.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η παρτίδα φωτογραφίζεται ακόμη· θα γίνει η επεξεργασία της μετά.</translation>
    </message>
    <message>
      <source>Joins with sherds that are not in the export or were not imported are left out: %1; enter them by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι συγκολλήσεις με όστρακα που δεν υπάρχουν στην εξαγωγή ή δεν καταχωρίστηκαν παραλείπονται: %1· καταχωρίστε τις με το χέρι.</translation>
    </message>
    <message>
      <source>'%1' can be read as %2 or as %3; write one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» διαβάζεται ως %2 ή ως %3· γράψτε ένα από τα δύο.</translation>
    </message>
    <message>
      <source>The batch is not fully processed; let the queue process it, then review its pairs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επεξεργασία της παρτίδας δεν ολοκληρώθηκε· αφήστε την ουρά να την επεξεργαστεί και μετά ελέγξτε τα ζεύγη της.</translation>
    </message>
    <message>
      <source>%1 was retaken after its mask was edited; the strokes on the earlier photograph are left out. Check its mask.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η %1 ξαναφωτογραφήθηκε αφού διορθώθηκε η μάσκα της· οι πινελιές στην προηγούμενη φωτογραφία παραλείπονται. Κοιτάξτε τη μάσκα της.</translation>
    </message>
    <message>
      <source>Joins with rows that were not imported are left out: %1; correct these rows, then import the table again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι συγκολλήσεις με γραμμές που δεν καταχωρίστηκαν παραλείπονται: %1· εισαγάγετε ξανά τον πίνακα όταν διορθωθούν αυτές οι γραμμές.</translation>
    </message>
    <message>
      <source>The sherd has a void_reason, so it is void; write void here, or %1 under void_reason.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όστρακο έχει void_reason, άρα είναι άκυρο· γράψτε εδώ void ή %1 στο void_reason.</translation>
    </message>
    <message>
      <source>A sherd is void only with a reason; write it under void_reason, or correct the state.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο είναι άκυρο μόνο με έναν λόγο· γράψτε τον στο void_reason ή διορθώστε την κατάσταση.</translation>
    </message>
    <message>
      <source>The state must be draft, numbered or void.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κατάσταση πρέπει να είναι draft, numbered ή void.</translation>
    </message>
    <message>
      <source>Rows that are not imported leave their numbers free: %1; correct and import them before you assign new numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι γραμμές που δεν εισάγονται αφήνουν ελεύθερους τους αριθμούς τους: %1· διορθώστε τις και εισαγάγετέ τις πριν δοθούν νέοι αριθμοί.</translation>
    </message>
    <message>
      <source>The number %1 was entered for a sherd of %2, which is not processed yet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 πληκτρολογήθηκε για όστρακο της %2, που δεν έχει επεξεργαστεί ακόμη.</translation>
    </message>
    <message>
      <source>A sheet of an earlier drawing already exists and is not overwritten; choose another name, or delete that sheet.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει φύλλο παλαιότερου σχεδίου και δεν αντικαθίσταται· διαλέξτε άλλο όνομα ή αφαιρέστε το.</translation>
    </message>
    <message>
      <source>Enter a number after =.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετά το σύμβολο = ακολουθεί αριθμός.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι φάκελος, όχι αρχείο· δώστε ένα αρχείο.</translation>
    </message>
    <message>
      <source>This is a pipe, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι διοχέτευση, όχι αρχείο· δώστε ένα αρχείο.</translation>
    </message>
    <message>
      <source>This is a socket, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι υποδοχή (socket), όχι αρχείο· δώστε ένα αρχείο.</translation>
    </message>
    <message>
      <source>This is a device, not a file; choose a file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι συσκευή, όχι αρχείο· δώστε ένα αρχείο.</translation>
    </message>
    <message>
      <source>A link has taken the place of this folder&apos;s lock file; delete the link.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας σύνδεσμος βρίσκεται στη θέση του κλειδώματος αυτού του φακέλου· διαγράψτε τον.</translation>
    </message>
    <message>
        <source>A link has taken the place of a folder of a project or of a result; what it leads to was not touched. Delete the link, or move the folder itself here.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ένας σύνδεσμος πήρε τη θέση ενός φακέλου έργου ή αποτελεσμάτων· αυτό στο οποίο οδηγεί δεν αγγίχτηκε. Διαγράψτε τον σύνδεσμο ή μετακινήστε τον ίδιο τον φάκελο εδώ.</translation>
    </message>
    <message>
      <source>No temporary folder can be created here (%1); free some space, or set TMPDIR to another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν μπορεί να δημιουργηθεί προσωρινός φάκελος εδώ (%1)· ελευθερώστε χώρο ή ορίστε άλλον φάκελο στο TMPDIR.</translation>
    </message>
    <message>
      <source>The JSON contains &apos;%1&apos; twice in one object; delete one of the two.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το JSON ονομάζει το «%1» δύο φορές σε ένα αντικείμενο· διαγράψτε ένα από τα δύο.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a whole number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» πρέπει να είναι ακέραιος από %2 έως %3· διορθώστε το.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number from %2 to %3; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» πρέπει να είναι αριθμός από %2 έως %3· διορθώστε το.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; must be a number; correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» πρέπει να είναι αριθμός· διορθώστε το.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is mirrored: its corners run counter-clockwise as seen from above; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δείκτης %1 του δίσκου είναι κατοπτρικός: από πάνω οι γωνίες του πηγαίνουν αριστερόστροφα· τυπώστε ξανά το αρχείο του δίσκου.</translation>
    </message>
    <message>
      <source>Marker %1 of the plate is not convex; list its corners in order along its edge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δείκτης %1 του δίσκου δεν είναι κυρτός· δώστε τις γωνίες του τη μία μετά την άλλη κατά μήκος της ακμής.</translation>
    </message>
    <message>
      <source>The markers %1 and %2 of the plate overlap; create the plate file again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δείκτες %1 και %2 του δίσκου επικαλύπτονται· τυπώστε ξανά το αρχείο του δίσκου.</translation>
    </message>
    <message>
      <source>The board&apos;s markers must be smaller than its squares; correct &apos;marker_mm&apos; or &apos;square_mm&apos;.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δείκτες του πίνακα βαθμονόμησης πρέπει να είναι μικρότεροι από τα τετράγωνά του· διορθώστε το «marker_mm» ή το «square_mm».</translation>
    </message>
    <message>
      <source>A face of the PLY file has more than %1 corners; export the file again as triangles.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια έδρα του PLY έχει πάνω από %1 γωνίες· εξαγάγετέ το ξανά ως τρίγωνα.</translation>
    </message>
    <message>
      <source>The PLY file has more than %1 of '%2'; export it with fewer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο PLY έχει πάνω από %1 από «%2»· εξαγάγετέ το με λιγότερα.</translation>
    </message>
    <message>
      <source>A link or a file has taken the place of a folder, or a link that of a file; replace it with the folder or the file itself.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας σύνδεσμος ή ένα αρχείο βρίσκεται στη θέση φακέλου, ή ένας σύνδεσμος στη θέση αρχείου· βάλτε εκεί τα ίδια τα αρχεία.</translation>
    </message>
    <message>
      <source>A file with this name already exists and is not overwritten; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υπάρχει ήδη αρχείο με αυτό το όνομα και δεν αντικαθίσταται· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>The export names a location in the project where no such file belongs; nothing was imported.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εξαγωγή δείχνει μια θέση του έργου όπου δεν ανήκει τέτοιο αρχείο· δεν εισήχθη τίποτα.</translation>
    </message>
    <message>
      <source>The archive contains a journal of its catalogue, which an Ostraka archive never contains; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχειοθετημένο έργο περιέχει ημερολόγιο του καταλόγου του, κάτι που δεν κάνει κανένα του Ostraka· δεν γράφτηκε τίποτα.</translation>
    </message>
    <message>
      <source>The catalogue&apos;s tables, indexes or triggers differ from those that Ostraka creates; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι πίνακες, τα ευρετήρια και οι σκανδάλες του καταλόγου δεν είναι όπως τα φτιάχνει το Ostraka· δεν γράφτηκε τίποτα.</translation>
    </message>
    <message>
      <source>The output folder is gone: it was moved or deleted while Ostraka was writing to it. The photographs are untouched; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος εξόδου δεν υπάρχει πια: μετακινήθηκε ή διαγράφηκε ενώ το πρόγραμμα έγραφε σε αυτόν. Οι φωτογραφίες είναι ανέπαφες· ξεκινήστε ξανά την ίδια εντολή.</translation>
    </message>
    <message>
      <source>The folder already contains files; choose a new or empty one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος περιέχει ήδη αρχεία· δώστε έναν νέο ή άδειο.</translation>
    </message>
    <message>
      <source>This location belongs to the archive or export &apos;%1&apos;, which new files would make invalid; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η θέση ανήκει στο αρχείο έργου ή στην εξαγωγή «%1», που θα έπαυε να ισχύει με νέα αρχεία· επιλέξτε μια θέση έξω από αυτό.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a location outside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η θέση ανήκει στο έργο «%1»· επιλέξτε μια θέση έξω από αυτό.</translation>
    </message>
    <message>
      <source>The name of this output must end in %1; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα αυτού του αρχείου εξόδου πρέπει να τελειώνει σε %1· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>This is a folder, not a file; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό είναι φάκελος, όχι αρχείο· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>This output is one of the input files, which it would overwrite; choose another name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η έξοδος είναι ένα από τα αρχεία εισόδου και θα το αντικαθιστούσε· επιλέξτε άλλο όνομα.</translation>
    </message>
    <message>
      <source>This location belongs to the project &apos;%1&apos;; choose a folder directly in &apos;%2&apos;, or one outside the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η θέση ανήκει στο έργο «%1»· επιλέξτε έναν φάκελο ακριβώς μέσα στο «%2», ή έναν έξω από το έργο.</translation>
    </message>
    <message>
      <source>This file describes another plate, or this plate with another ruler length; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο περιγράφει άλλον δίσκο, ή αυτόν τον δίσκο με άλλο μήκος χάρακα· επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>This file describes another calibration board; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο περιγράφει άλλον πίνακα βαθμονόμησης· επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>This folder contains photographs, and a new plate.json would describe the sheet under their sherds; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε αυτόν τον φάκελο υπάρχουν φωτογραφίες, και ένα νέο plate.json θα περιέγραφε το φύλλο κάτω από τα όστρακά τους· επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>This folder is a mount point or the current folder; choose a new folder inside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος είναι ξεχωριστός δίσκος ή εκείνος στον οποίο βρίσκεστε· δώστε έναν νέο φάκελο μέσα του.</translation>
    </message>
    <message>
      <source>This folder is needed for unfinished files but contains others; move it elsewhere.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος χρειάζεται για ημιτελή αρχεία, αλλά περιέχει άλλα· μετακινήστε τον.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the front side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα αντικείμενο με %1 % του μήκους του συνηθισμένου οστράκου παραλείφθηκε από την μπροστινή όψη· χωρίς κλίμακα μπορεί να είναι όστρακο.</translation>
    </message>
    <message>
      <source>An object of %1 % of the typical sherd&apos;s length was left out of the back side; without a scale, it may be a sherd.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα αντικείμενο με %1 % του μήκους του συνηθισμένου οστράκου παραλείφθηκε από την πίσω όψη· χωρίς κλίμακα μπορεί να είναι όστρακο.</translation>
    </message>
    <message>
      <source>The photographs of the front side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες της μπροστινής όψης συμφωνούν μόνο στο %1 % όσων δείχνουν οι μάσκες της, οπότε οι σαρώσεις της μπορεί να είναι λάθος. Ελέγξτε τις μάσκες, και ότι τίποτα δεν μετακινήθηκε κατά τη φωτογράφιση.</translation>
    </message>
    <message>
      <source>The photographs of the back side agree on only %1 % of what its masks show, so its scans may be wrong. Check the masks, and that nothing moved while they were taken.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες της πίσω όψης συμφωνούν μόνο στο %1 % όσων δείχνουν οι μάσκες της, οπότε οι σαρώσεις της μπορεί να είναι λάθος. Ελέγξτε τις μάσκες, και ότι τίποτα δεν μετακινήθηκε κατά τη φωτογράφιση.</translation>
    </message>
    <message>
      <source>All photographs look at the sheet from straight above, so heights and wall thicknesses are uncertain and broken edges are hardly seen. Add photographs from the side, tilted by 30 to 60 degrees.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλες οι φωτογραφίες κοιτούν το φύλλο κατακόρυφα από πάνω, οπότε τα ύψη και τα πάχη των τοιχωμάτων είναι αβέβαια και οι σπασμένες ακμές σχεδόν δεν φαίνονται. Προσθέστε φωτογραφίες από το πλάι, με κλίση 30 έως 60 μοιρών.</translation>
    </message>
    <message>
      <source>If it is one, photograph it alone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αν είναι, φωτογραφίστε το μόνο του.</translation>
    </message>
    <message>
        <source>The catalogue is damaged (%1); nothing was changed, and no backup was deleted. Restore it with 'ostraka catalogue repair PROJECT'.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο κατάλογος είναι κατεστραμμένος (%1)· τίποτα δεν άλλαξε και κανένα αντίγραφο ασφαλείας δεν διαγράφηκε. Επαναφέρετέ τον με «ostraka catalogue repair PROJECT».</translation>
    </message>
    <message>
        <source>a page was changed</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>μια σελίδα άλλαξε</translation>
    </message>
    <message>
        <source>it is a backup, but the -wal file beside it belongs to the catalogue that it replaced</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>είναι αντίγραφο ασφαλείας, αλλά το αρχείο -wal δίπλα του ανήκει στον κατάλογο που αντικατέστησε</translation>
    </message>
    <message>
        <source>its repair was interrupted</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>η επισκευή του διακόπηκε</translation>
    </message>
    <message>
        <source>its pages are inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>οι σελίδες του δεν ταιριάζουν μεταξύ τους</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>το αρχείο είναι κενό</translation>
    </message>
    <message>
        <source>the file is not a database</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>το αρχείο δεν είναι βάση δεδομένων</translation>
    </message>
    <message>
        <source>the file belongs to another program</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>το αρχείο ανήκει σε άλλο πρόγραμμα</translation>
    </message>
    <message>
        <source>the file contains no catalogue</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>το αρχείο δεν περιέχει κατάλογο</translation>
    </message>
    <message>
        <source>the header is inconsistent</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>η κεφαλίδα αντιφάσκει</translation>
    </message>
    <message>
        <source>it contains no project</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>δεν περιέχει έργο</translation>
    </message>
    <message>
        <source>The catalogue cannot be read; check that it exists and check its permissions.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο κατάλογος δεν διαβάζεται· ελέγξτε ότι υπάρχει, καθώς και τα δικαιώματά του.</translation>
    </message>
    <message>
        <source>This project is read-only, and there is no space for the copy that Ostraka reads; free some space in the folder for temporary files.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αυτό το έργο μπορεί μόνο να διαβαστεί και δεν υπάρχει χώρος για αντίγραφο ανάγνωσης· ελευθερώστε χώρο στον φάκελο προσωρινών αρχείων.</translation>
    </message>
    <message>
        <source>An older Ostraka made this project, and it is read-only here; copy it to a folder that you can write to, and open it there.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αυτό το έργο έγινε με παλαιότερο Ostraka και εδώ μπορεί μόνο να διαβαστεί· αντιγράψτε το σε φάκελο όπου μπορείτε να γράψετε και ανοίξτε το εκεί.</translation>
    </message>
    <message>
        <source>The catalogue is damaged, and none of its backups is intact; copy one from an archive or another disk into the folder backups, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο κατάλογος είναι κατεστραμμένος και κανένα αντίγραφο ασφαλείας του δεν είναι ακέραιο· αντιγράψτε ένα στον φάκελο backups, από αρχειοθήκη ή άλλον δίσκο, και επισκευάστε τον ξανά.</translation>
    </message>
    <message>
        <source>Another program has this project open; close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Άλλο πρόγραμμα έχει ανοιχτό αυτό το έργο· κλείστε το εκεί και μετά επισκευάστε το.</translation>
    </message>
    <message>
        <source>%1 rows in total, %2 read; run the same import again for the others.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Από %1 γραμμές διαβάστηκαν %2· η ίδια εισαγωγή καταχωρίζει τις υπόλοιπες.</translation>
    </message>
    <message>
      <source>The column &apos;%1&apos; means the same as &apos;%2&apos;; its values are kept as a custom field.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η στήλη &apos;%1&apos; λέει το ίδιο με τη &apos;%2&apos;· οι τιμές της μένουν σε δικό σας πεδίο.</translation>
    </message>
    <message>
      <source>Check the drawing of %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε το σχέδιο του %1: %2</translation>
    </message>
    <message>
      <source>sherd %1 of %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>όστρακο %1 της %2</translation>
    </message>
    <message>
      <source>camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: %2</translation>
    </message>
    <message>
      <source>%1 and %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 και %2</translation>
    </message>
    <message>
      <source>Camera %1: %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1: %2</translation>
    </message>
    <message>
      <source>The focal length is not determined: %1 px with a standard deviation of %2 px; take more pictures, closer and with the board tilted by 20 to 45 degrees in different directions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η εστιακή απόσταση δεν καθορίστηκε: %1 px με τυπική απόκλιση %2 px· τραβήξτε περισσότερες εικόνες, από πιο κοντά και με τον πίνακα βαθμονόμησης σε κλίση 20 έως 45 μοιρών προς διαφορετικές κατευθύνσεις.</translation>
    </message>
    <message>
      <source>No picture shows the board tilted by more than 15 degrees; tilt it more to separate focal length from distance.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>καμία εικόνα δεν δείχνει τον πίνακα βαθμονόμησης με κλίση πάνω από 15 μοίρες· δώστε του μεγαλύτερη κλίση, για να ξεχωρίζει η εστιακή απόσταση από την απόσταση.</translation>
    </message>
    <message>
      <source>The corners scatter by %1 px, more than the 0.3 px of sharp pictures of a flat board; check focus, lighting and the board's flatness.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>οι γωνίες διασπείρονται κατά %1 px, περισσότερο από τα 0,3 px ευκρινών εικόνων ενός επίπεδου πίνακα· ελέγξτε εστίαση, φως και αν ο πίνακας είναι επίπεδος.</translation>
    </message>
    <message>
      <source>The worst picture is %1 with %2 px; retake it or leave it out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η χειρότερη εικόνα είναι η %1 με %2 px· τραβήξτε την ξανά ή αφήστε την έξω.</translation>
    </message>
    <message>
      <source>Calibration pictures that show the board: %1; at least 3 are needed. Take more pictures of it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εικόνες βαθμονόμησης όπου φαίνεται ο πίνακας: %1· χρειάζονται τουλάχιστον 3. Τραβήξτε περισσότερες.</translation>
    </message>
    <message>
      <source>Camera %1, position %2: %3.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1, στάση %2: %3.</translation>
    </message>
    <message>
      <source>%1 poses are given for %2 photographs; give one pose for each.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δίνονται %1 θέσεις για %2 φωτογραφίες· δώστε μία θέση για καθεμία.</translation>
    </message>
    <message>
      <source>its front no longer has a back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η μπροστινή του όψη δεν έχει πια πίσω όψη</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about ten times the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε τη μονάδα: %1 είναι περίπου δεκαπλάσιο της υπολογισμένης τιμής.</translation>
    </message>
    <message>
      <source>Check the unit: %1 is about a tenth of the computed value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε τη μονάδα: %1 είναι περίπου το ένα δέκατο της υπολογισμένης τιμής.</translation>
    </message>
    <message>
      <source>Check the value: %1 differs from the computed value by a factor of three or more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε την τιμή: %1 απέχει τουλάχιστον τρεις φορές από την υπολογισμένη τιμή.</translation>
    </message>
    <message>
      <source>Check the values: %1 (%2) is below %3 (%4).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ελέγξτε τις τιμές: %1 (%2) είναι μικρότερο από: %3 (%4).</translation>
    </message>
    <message>
      <source>The computed value is %1. Delete it?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η υπολογισμένη τιμή είναι %1. Διαγραφή;</translation>
    </message>
    <message>
      <source>The computed value is %1. Replace it with the measured value?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η υπολογισμένη τιμή είναι %1. Αντικατάσταση με τη μετρημένη τιμή;</translation>
    </message>
    <message>
      <source>the length</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το μήκος</translation>
    </message>
    <message>
      <source>the width</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το πλάτος</translation>
    </message>
    <message>
      <source>the minimum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το ελάχιστο πάχος</translation>
    </message>
    <message>
      <source>the maximum thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το μέγιστο πάχος</translation>
    </message>
    <message>
      <source>the thickness</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>το πάχος</translation>
    </message>
    <message>
      <source>(%1, %2) mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>(%1, %2) mm</translation>
    </message>
    <message>
      <source>The sherds could not be counted: too few of the plate&apos;s markers are visible.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα δεν μετρήθηκαν: φαίνονται πολύ λίγοι δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>No sherd is visible on the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν φαίνεται κανένα όστρακο στον δίσκο.</translation>
    </message>
    <message>
      <source>Sherds touch or nearly touch at %1 from the plate&apos;s centre: move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα αγγίζονται ή σχεδόν αγγίζονται στο %1 από το μέσο του δίσκου: απομακρύνετέ τα και φωτογραφίστε ξανά.</translation>
    </message>
    <message>
      <source>What lies at %1 from the plate&apos;s centre was counted as one but may be two touching sherds: check it; if so, move them apart and reshoot.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι βρίσκεται στο %1 από το μέσο του δίσκου μετρήθηκε ως ένα, ίσως όμως είναι δύο όστρακα που αγγίζονται: κοιτάξτε εκεί· αν είναι έτσι, απομακρύνετέ τα και φωτογραφίστε ξανά.</translation>
    </message>
    <message>
      <source>The back looks like the front: turn the sherds over and reshoot them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η πίσω όψη μοιάζει με την μπροστινή: γυρίστε τα όστρακα και φωτογραφίστε τα ξανά.</translation>
    </message>
    <message>
      <source>The sherds of the back could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα της πίσω όψης δεν μετρήθηκαν: συγκρίνετε μόνοι σας τις εικόνες πριν αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>The sherds of the front could not be counted: compare the pictures before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα όστρακα της μπροστινής όψης δεν μετρήθηκαν: συγκρίνετε μόνοι σας τις εικόνες πριν αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>%1, %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, %2</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Find the missing ones before you clear the plate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα που μετρήθηκαν στην μπροστινή όψη: %1, στην πίσω: %2. Βρείτε όσα λείπουν πριν αδειάσετε τον δίσκο.</translation>
    </message>
    <message>
      <source>Sherds counted on the front: %1, on the back: %2. Check whether one was added or broke.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα που μετρήθηκαν στην μπροστινή όψη: %1, στην πίσω: %2. Ελέγξτε μήπως προστέθηκε ή έσπασε κάποιο.</translation>
    </message>
    <message>
      <source>The turntable&apos;s own count was %1 degrees off; it was corrected from the plate&apos;s markers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μέτρηση του περιστρεφόμενου τραπεζιού απείχε κατά %1 μοίρες· διορθώθηκε από τους δείκτες του δίσκου.</translation>
    </message>
    <message>
      <source>Not an Ostraka project: this folder has no catalogue.sqlite; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι έργο του Ostraka: ο φάκελος δεν έχει catalogue.sqlite· δεν συγχωνεύτηκε τίποτα.</translation>
    </message>
    <message>
      <source>Another version of Ostraka made this project; nothing was merged. Open it once with this version, which updates it, or install the newer version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλη έκδοση του Ostraka δημιούργησε αυτό το έργο· δεν συγχωνεύτηκε τίποτα. Ανοίξτε το μία φορά με αυτή την έκδοση, που το ενημερώνει, ή εγκαταστήστε τη νεότερη.</translation>
    </message>
    <message>
      <source>A project cannot be merged with itself; name another project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα έργο δεν μπορεί να συγχωνευτεί με τον εαυτό του· δώστε άλλο έργο.</translation>
    </message>
    <message>
      <source>This project is read-only here, so nothing was merged; copy it to a folder that you can write to.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο είναι εδώ μόνο για ανάγνωση, γι’ αυτό δεν συγχωνεύτηκε τίποτα· αντιγράψτε το σε φάκελο όπου μπορείτε να γράψετε.</translation>
    </message>
    <message>
      <source>The project changed while files were copied, so nothing was merged; run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το έργο άλλαξε ενώ αντιγράφονταν αρχεία, γι’ αυτό δεν συγχωνεύτηκε τίποτα· εκτελέστε ξανά την ίδια εντολή.</translation>
    </message>
    <message>
      <source>The conflict %1 (%2) cannot be settled with &apos;%3&apos;; nothing was merged. Choose one of the ways that the list of conflicts offers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σύγκρουση %1 (%2) δεν λύνεται με «%3»· δεν συγχωνεύτηκε τίποτα. Επιλέξτε έναν από τους τρόπους που δίνει ο κατάλογος των συγκρούσεων.</translation>
    </message>
    <message>
      <source>This file must be a JSON list of {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} or {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}; nothing was merged. Correct the file.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο πρέπει να είναι λίστα JSON από {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} ή {&quot;id&quot;: &quot;…&quot;, &quot;number&quot;: &quot;…&quot;}· δεν συγχωνεύτηκε τίποτα. Διορθώστε το αρχείο.</translation>
    </message>
    <message>
      <source>The conflict %1 is settled twice in this file; nothing was merged. Keep one of the two entries.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σύγκρουση %1 λύνεται δύο φορές στο αρχείο· δεν συγχωνεύτηκε τίποτα. Κρατήστε μία από τις δύο εγγραφές.</translation>
    </message>
    <message>
      <source>This file of project B differs from what its catalogue records; nothing was merged. Restore it from a copy (&apos;ostraka catalogue check&apos; lists all such files).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο αυτό του έργου B διαφέρει από ό,τι καταγράφει ο κατάλογός του· δεν συγχωνεύτηκε τίποτα. Επαναφέρετέ το από αντίγραφο (το «ostraka catalogue check» απαριθμεί όλα αυτά τα αρχεία).</translation>
    </message>
    <message>
      <source>The disk does not return what was written to it; nothing was merged. Check the disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος αποθήκευσης δεν επιστρέφει ό,τι γράφτηκε σε αυτόν· δεν συγχωνεύτηκε τίποτα. Ελέγξτε τον.</translation>
    </message>
    <message>
      <source>A link or a device cannot be merged; nothing was merged. Move what it leads to into project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύνδεσμος ή συσκευή δεν συγχωνεύεται· δεν συγχωνεύτηκε τίποτα. Μετακινήστε στο έργο B εκείνο όπου οδηγεί.</translation>
    </message>
    <message>
      <source>Results from a cluster must be regular files with plain names; nothing of this batch was entered. Submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα αποτελέσματα μιας συστοιχίας πρέπει να είναι κανονικά αρχεία με απλά ονόματα· από αυτή την παρτίδα δεν καταχωρίστηκε τίποτα. Υποβάλετέ την ξανά.</translation>
    </message>
    <message>
      <source>This batch was processed here or reshot in the meantime; the cluster&apos;s results are not entered.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στο μεταξύ η παρτίδα υποβλήθηκε σε επεξεργασία εδώ ή φωτογραφήθηκε ξανά· τα αποτελέσματα της συστοιχίας δεν καταχωρίζονται.</translation>
    </message>
    <message>
      <source>The name of a partition or an account consists of letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;; look it up with &apos;sinfo&apos; or ask the cluster&apos;s administrators.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα μιας κατάτμησης ή ενός λογαριασμού αποτελείται από γράμματα, ψηφία, «-», «_» και «.»· αναζητήστε το με «sinfo» ή ρωτήστε τους διαχειριστές της συστοιχίας.</translation>
    </message>
    <message>
      <source>The command that starts Ostraka on the cluster must be one line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η εντολή που ξεκινά το Ostraka στη συστοιχία πρέπει να είναι μία γραμμή.</translation>
    </message>
    <message>
      <source>A job needs at least one core, and its memory and time must not be negative.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια εργασία χρειάζεται τουλάχιστον έναν πυρήνα, και η μνήμη και ο χρόνος της δεν μπορούν να είναι αρνητικά.</translation>
    </message>
    <message>
      <source>This folder cannot be opened (%1); check its name and permissions.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος δεν ανοίγει (%1)· ελέγξτε το όνομα και τα δικαιώματά του.</translation>
    </message>
    <message>
      <source>The path of this project contains a character that has a special meaning for Slurm (%, a backslash or a control character); rename the folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η διαδρομή του έργου περιέχει χαρακτήρα με ειδική σημασία για το Slurm (%, ανάστροφη κάθετο ή χαρακτήρα ελέγχου)· μετονομάστε τον φάκελο.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH; run this command on a login node of the cluster, or name one with --host USER@LOGIN:/FOLDER.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα %1 δεν είναι στο PATH αυτού του υπολογιστή· εκτελέστε την εντολή σε κόμβο σύνδεσης της συστοιχίας ή δώστε έναν με --host USER@LOGIN:/FOLDER.</translation>
    </message>
    <message>
      <source>Not a folder on a cluster; write USER@LOGIN:/FOLDER, with the folder&apos;s full path and without spaces.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι φάκελος σε συστοιχία· γράψτε USER@LOGIN:/FOLDER, με την πλήρη διαδρομή του φακέλου και χωρίς κενά.</translation>
    </message>
    <message>
      <source>The program %1 is not on this computer&apos;s PATH, but --host needs it; install it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα %1 δεν είναι στο PATH αυτού του υπολογιστή, αλλά το --host το χρειάζεται· εγκαταστήστε το.</translation>
    </message>
    <message>
      <source>The program %1 cannot be started there; ask the cluster&apos;s administrators how Slurm is reached.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα %1 δεν ξεκινά εκεί· ρωτήστε τους διαχειριστές της συστοιχίας πώς είναι προσβάσιμο το Slurm.</translation>
    </message>
    <message>
      <source>%1 failed (%2). Nothing is lost; once the cause is removed, run the same command again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 απέτυχε (%2). Δεν χάθηκε τίποτα· όταν αρθεί η αιτία, εκτελέστε ξανά την ίδια εντολή.</translation>
    </message>
    <message>
      <source>This batch contains imported scans and is not submitted; the window&apos;s queue processes it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα περιέχει εισαγμένες σαρώσεις και δεν υποβάλλεται· την επεξεργάζεται η ουρά του παραθύρου.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk has %1 GB left, but the batches to submit (%2) need about %3 GB. Nothing was submitted; free some space, or submit fewer with --most.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Στον δίσκο της συστοιχίας μένουν %1 GB, αλλά οι παρτίδες προς υποβολή (%2) χρειάζονται περίπου %3 GB. Δεν υποβλήθηκε τίποτα· ελευθερώστε χώρο ή υποβάλετε λιγότερες με --most.</translation>
    </message>
    <message>
      <source>Batches of this project are on another cluster or in another folder; collect them before you submit to this one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδες του έργου βρίσκονται σε άλλη συστοιχία ή σε άλλον φάκελο· συλλέξτε τις πριν υποβάλετε εδώ.</translation>
    </message>
    <message>
      <source>Not a list of the batches on a cluster; restore an earlier one, or delete it: batches that are on the cluster are then processed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι κατάλογος παρτίδων σε συστοιχία· επαναφέρετε έναν προηγούμενο ή διαγράψτε τον: οι παρτίδες της συστοιχίας θα υποβληθούν τότε ξανά σε επεξεργασία.</translation>
    </message>
    <message>
      <source>Out of memory (%1 MB requested); the next submission requests twice as much.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η μνήμη εξαντλήθηκε (ζητήθηκαν %1 MB)· η επόμενη υποβολή ζητά τη διπλάσια.</translation>
    </message>
    <message>
      <source>Out of time (minutes requested: %1); the next submission requests twice as many and resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο χρόνος τελείωσε (λεπτά που ζητήθηκαν: %1)· η επόμενη υποβολή ζητά τα διπλάσια και συνεχίζει μετά το τελευταίο ολοκληρωμένο στάδιο.</translation>
    </message>
    <message>
      <source>The node failed, or the job was killed; the next submission resumes after the last complete stage.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κόμβος απέτυχε ή η εργασία τερματίστηκε· η επόμενη υποβολή συνεχίζει μετά το τελευταίο ολοκληρωμένο στάδιο.</translation>
    </message>
    <message>
      <source>The cluster&apos;s disk is full, or your quota is used up; free some space, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο δίσκος της συστοιχίας γέμισε ή το όριό σας εξαντλήθηκε· ελευθερώστε χώρο και υποβάλετε ξανά.</translation>
    </message>
    <message>
      <source>The cluster does not know this job, and the job wrote nothing into the project&apos;s folder; check that the cluster&apos;s nodes see that folder, then submit again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η συστοιχία δεν γνωρίζει αυτή την εργασία, και η εργασία δεν έγραψε τίποτα στον φάκελο του έργου· ελέγξτε ότι οι κόμβοι της συστοιχίας βλέπουν τον φάκελο και υποβάλετε ξανά.</translation>
    </message>
    <message>
      <source>The program ended with status %1; its output is in %2.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρόγραμμα τελείωσε με κωδικό %1· η έξοδός του βρίσκεται στο %2.</translation>
    </message>
    <message>
      <source>The partition ends jobs earlier than the %1 minutes requested; cancel the job, then submit again with another --partition or fewer --minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κατάτμηση τερματίζει τις εργασίες πριν από τα %1 λεπτά που ζητήθηκαν· ακυρώστε την εργασία και υποβάλετε ξανά με άλλο --partition ή λιγότερα --minutes.</translation>
    </message>
    <message>
      <source>Slurm&apos;s reason: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Λόγος κατά το Slurm: %1.</translation>
    </message>
    <message>
      <source>This network cannot be used: %1. Choose an ONNX network that takes 1 x 3 x H x W and gives 1 x 1 x h x w or 1 x 2 x h x w.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το δίκτυο δεν μπορεί να χρησιμοποιηθεί: %1. Επιλέξτε δίκτυο ONNX που παίρνει 1 x 3 x H x W και δίνει 1 x 1 x h x w ή 1 x 2 x h x w.</translation>
    </message>
    <message>
      <source>it cannot be run (%1)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δεν εκτελείται (%1)</translation>
    </message>
    <message>
      <source>its output has another shape</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η έξοδός του έχει άλλο σχήμα</translation>
    </message>
    <message>
      <source>its output contains numbers that are not finite</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η έξοδός του περιέχει αριθμούς που δεν είναι πεπερασμένοι</translation>
    </message>
    <message>
      <source>its input is not an image</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η είσοδός του δεν είναι εικόνα</translation>
    </message>
    <message>
      <source>its input has %1 channels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η είσοδός του έχει %1 κανάλια</translation>
    </message>
    <message>
      <source>its input is larger than %1 pixels</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η είσοδός του ξεπερνά τα %1 εικονοστοιχεία</translation>
    </message>
    <message>
      <source>You have no permission to use it: copy packaging/udev/70-ostraka.rules to /etc/udev/rules.d/ and plug it in again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν έχετε δικαίωμα να τη χρησιμοποιήσετε: αντιγράψτε το packaging/udev/70-ostraka.rules στο /etc/udev/rules.d/ και συνδέστε την ξανά.</translation>
    </message>
    <message>
      <source>It is in use by %1: &apos;ostraka devices --release&apos; releases it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τη χρησιμοποιεί το %1: το «ostraka devices --release» την ελευθερώνει.</translation>
    </message>
    <message>
      <source>It is in use by %1: close that program.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τη χρησιμοποιεί το %1: κλείστε αυτό το πρόγραμμα.</translation>
    </message>
    <message>
      <source>The kernel has no driver for it; install one for this adapter.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πυρήνας του συστήματος δεν έχει πρόγραμμα οδήγησης για αυτήν· εγκαταστήστε ένα για αυτόν τον προσαρμογέα.</translation>
    </message>
    <message>
      <source>A folder of the project cannot be read (%1); check its permissions, then archive the project again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας φάκελος του έργου δεν διαβάζεται (%1)· ελέγξτε τα δικαιώματά του και αρχειοθετήστε ξανά το έργο.</translation>
    </message>
    <message>
      <source>No output folder was given; name one with --output OUT.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε φάκελος εξόδου· δώστε έναν με --output OUT.</translation>
    </message>
    <message>
      <source>No folder of front scans was given; name one with --front DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε φάκελος με σαρώσεις μπροστινών όψεων· δώστε έναν με --front DIR.</translation>
    </message>
    <message>
      <source>No folder of back scans was given; name one with --back DIR.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε φάκελος με σαρώσεις πίσω όψεων· δώστε έναν με --back DIR.</translation>
    </message>
    <message>
      <source>The field %1 has no unit &apos;%2&apos;; choose another unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πεδίο %1 δεν έχει μονάδα «%2»· επιλέξτε άλλη μονάδα.</translation>
    </message>
    <message>
      <source>The table has no column &apos;%1&apos;; check its name.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο πίνακας δεν έχει στήλη «%1»· ελέγξτε το όνομά της.</translation>
    </message>
    <message>
      <source>The columns &apos;%1&apos; and &apos;%2&apos; are both mapped to the field %3; leave one of them out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι στήλες «%1» και «%2» αντιστοιχούν και οι δύο στο πεδίο %3· παραλείψτε τη μία.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; maps no column; write COLUMN=FIELD or COLUMN=FIELD:unit.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το «%1» δεν αντιστοιχίζει στήλη· γράψτε COLUMN=FIELD ή COLUMN=FIELD:unit.</translation>
    </message>
    <message>
      <source>The scan&apos;s colours or qualities differ in number from its points; give one for each point.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα χρώματα ή οι τιμές ποιότητας της σάρωσης δεν είναι όσα τα σημεία της· δώστε ένα για κάθε σημείο.</translation>
    </message>
    <message>
      <source>The pixels or the mask differ in size from the stated width and height; give one value for each pixel.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα εικονοστοιχεία ή η μάσκα δεν αντιστοιχούν στο δηλωμένο πλάτος και ύψος· δώστε μία τιμή για κάθε εικονοστοιχείο.</translation>
    </message>
    <message>
      <source>No scan of this side was given; give at least one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν δόθηκε σάρωση αυτής της όψης· δώστε τουλάχιστον μία.</translation>
    </message>
    <message>
      <source>give them in mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>δώστε τις σε mm</translation>
    </message>
    <message>
      <source>A remark in this file cannot be read; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια παρατήρηση στο αρχείο δεν διαβάζεται· επαναφέρετε παλαιότερο αντίγραφό του ή επεξεργαστείτε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>Camera %1, position %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κάμερα %1, στάση %2</translation>
    </message>
    <message>
        <source>%1: from %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: από %2</translation>
    </message>
    <message>
        <source>%1: from the history</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: από το ιστορικό</translation>
    </message>
    <message>
        <source>%1: not restored</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: δεν αποκαταστάθηκε</translation>
    </message>
    <message>
      <source>draft %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προσχέδιο %1</translation>
    </message>
    <message>
      <source>The remarks in this file are longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι παρατηρήσεις στο αρχείο υπερβαίνουν τα %1 byte· επαναφέρετε παλαιότερο αντίγραφό του ή επεξεργαστείτε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>A remark in this file is nested more than %1 levels deep; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια παρατήρηση στο αρχείο έχει περισσότερα από %1 επίπεδα ένθεσης· επαναφέρετε παλαιότερο αντίγραφό του ή επεξεργαστείτε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>The template of a remark in this file is longer than %1 bytes; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πρότυπο μιας παρατήρησης στο αρχείο υπερβαίνει τα %1 byte· επαναφέρετε παλαιότερο αντίγραφό του ή επεξεργαστείτε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>A remark in this file uses a value more than %1 times; restore an earlier copy of the file, or reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια παρατήρηση στο αρχείο χρησιμοποιεί μια τιμή περισσότερες από %1 φορές· επαναφέρετε παλαιότερο αντίγραφό του ή επεξεργαστείτε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>The version of the damaged catalogue cannot be read, so this repair relies on the backup %1. If a newer Ostraka has changed this project since, put the damaged file back and repair it with that version.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η έκδοση του κατεστραμμένου καταλόγου δεν διαβάζεται, γι’ αυτό η επισκευή βασίζεται στο αντίγραφο ασφαλείας %1. Αν νεότερο Ostraka άλλαξε έκτοτε το έργο, επαναφέρετε το κατεστραμμένο αρχείο και επισκευάστε το με εκείνη την έκδοση.</translation>
    </message>
    <message>
      <source>The setting %1 of project B says that two different things are the same; nothing was merged. Ask for another copy of project B.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η ρύθμιση %1 του έργου B λέει ότι δύο διαφορετικά πράγματα είναι το ίδιο· δεν συγχωνεύτηκε τίποτα. Ζητήστε άλλο αντίγραφο του έργου B.</translation>
    </message>
    <message>
      <source>The number or code %1 is already in use; nothing was merged. Settle the conflict %2 with another one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός ή κωδικός %1 χρησιμοποιείται ήδη· δεν συγχωνεύτηκε τίποτα. Λύστε τη σύγκρουση %2 με άλλον.</translation>
    </message>
    <message>
      <source>A new number cannot be empty; nothing was merged. Enter a number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας νέος αριθμός δεν μπορεί να είναι κενός· δεν συγχωνεύτηκε τίποτα. Δώστε έναν αριθμό.</translation>
    </message>
    <message>
      <source>The merged catalogue would be inconsistent, so nothing was merged; report this with a copy of both projects.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο συγχωνευμένος κατάλογος θα ήταν ασυνεπής, γι’ αυτό δεν συγχωνεύτηκε τίποτα· αναφέρετέ το μαζί με αντίγραφο των δύο έργων.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the front of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτά τα αποτελέσματα έγιναν από παλαιότερες φωτογραφίες της μπροστινής όψης της %1· επεξεργαστείτε την ξανά.</translation>
    </message>
    <message>
      <source>These results were made from earlier photographs of the back of %1; process it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτά τα αποτελέσματα έγιναν από παλαιότερες φωτογραφίες της πίσω όψης της %1· επεξεργαστείτε την ξανά.</translation>
    </message>
    <message>
      <source>Photographs of %1 that are missing or are others than these results were made from: %2 of %3. The results are entered; reprocess the batch if it was photographed again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της %1 που λείπουν ή είναι άλλες από εκείνες από τις οποίες έγιναν τα αποτελέσματα: %2 από %3. Τα αποτελέσματα καταχωρίστηκαν· επεξεργαστείτε ξανά την παρτίδα, αν φωτογραφήθηκε ξανά.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; the cluster&apos;s results are not entered. Submit it again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα φωτογραφήθηκε ξανά μετά την υποβολή της· τα αποτελέσματα της συστοιχίας δεν καταχωρίζονται. Υποβάλετέ την ξανά.</translation>
    </message>
    <message>
      <source>This batch was photographed again after it was submitted; its job %1 is of no use any more. Cancel it with &apos;scancel&apos;, or wait until it has ended, then submit the batch again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η παρτίδα φωτογραφήθηκε ξανά μετά την υποβολή της· η εργασία της %1 δεν χρησιμεύει πια. Ακυρώστε την με &apos;scancel&apos; ή περιμένετε να τελειώσει και υποβάλετε ξανά την παρτίδα.</translation>
    </message>
    <message>
      <source>Batches of this project were submitted to this host, which was not named on this computer; nothing was sent to it. If you trust it, name it once with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδες του έργου υποβλήθηκαν σε αυτόν τον διακομιστή, που δεν έχει δηλωθεί σε αυτόν τον υπολογιστή· δεν του στάλθηκε τίποτα. Αν τον εμπιστεύεστε, δηλώστε τον μία φορά με --host.</translation>
    </message>
    <message>
      <source>Not a file in which Ostraka remembers the host of a cluster; delete it, then name the host with --host.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι αρχείο όπου το Ostraka θυμάται τον διακομιστή μιας συστοιχίας· διαγράψτε το και δηλώστε τον διακομιστή με --host.</translation>
    </message>
    <message>
      <source>A job can request at most %1 MB of memory and %2 minutes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια εργασία μπορεί να ζητήσει το πολύ %1 MB μνήμης και %2 λεπτά.</translation>
    </message>
    <message>
      <source>This photograph is identical to %1 of the front side; it is left out of both sides.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτή η φωτογραφία είναι ίδια με την %1 της μπροστινής όψης· παραλείπεται και στις δύο όψεις.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the front side are identical to photographs of the back side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 από τις %2 φωτογραφίες της μπροστινής όψης είναι ίδιες με φωτογραφίες της πίσω (π.χ. %3), οπότε η παρτίδα δεν μπορεί να χρησιμοποιηθεί· δώστε σε κάθε όψη τις δικές της φωτογραφίες.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of the back side are identical to photographs of the front side (such as %3), so the batch cannot be used; give each side its own photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 από τις %2 φωτογραφίες της πίσω όψης είναι ίδιες με φωτογραφίες της μπροστινής (π.χ. %3), οπότε η παρτίδα δεν μπορεί να χρησιμοποιηθεί· δώστε σε κάθε όψη τις δικές της φωτογραφίες.</translation>
    </message>
    <message>
      <source>The field %1 was changed meanwhile; nothing was undone or redone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το πεδίο %1 άλλαξε στο μεταξύ· τίποτα δεν αναιρέθηκε ούτε επαναλήφθηκε.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term; choose one of %2, or add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το &apos;%1&apos; δεν είναι όρος· επιλέξτε έναν από: %2, ή προσθέστε τον στις ρυθμίσεις.</translation>
    </message>
    <message>
      <source>&apos;%1&apos; is not a term: the vocabulary is empty; add it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το &apos;%1&apos; δεν είναι όρος: το λεξιλόγιο είναι κενό· προσθέστε τον στις ρυθμίσεις.</translation>
    </message>
    <message>
      <source>why this row was not imported</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γιατί δεν εισήχθη αυτή η γραμμή</translation>
    </message>
    <message>
      <source>Read as a table of contexts and bags: no column has the sherds&apos; numbers.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διαβάστηκε ως πίνακας πλαισίων και σακουλών: καμία στήλη δεν έχει τους αριθμούς των οστράκων.</translation>
    </message>
    <message>
      <source>Read as a table of sherds: the column &apos;%1&apos; identifies them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διαβάστηκε ως πίνακας οστράκων: η στήλη &apos;%1&apos; τα προσδιορίζει.</translation>
    </message>
    <message>
      <source>No column has the sherds&apos; numbers, but &apos;%1&apos; is a column of sherds; select the column of numbers, or leave &apos;%1&apos; out if this is a table of contexts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Καμία στήλη δεν έχει τους αριθμούς των οστράκων, αλλά η &apos;%1&apos; είναι στήλη οστράκων· επιλέξτε τη στήλη των αριθμών ή παραλείψτε την &apos;%1&apos;, αν αυτός είναι πίνακας πλαισίων.</translation>
    </message>
    <message>
        <source>%1: not restored; it belongs to %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1: δεν αποκαταστάθηκε· ανήκει στο %2</translation>
    </message>
    <message>
      <source>Only measurements and days accept &lt; and &gt;; write %1:value.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μόνο μετρήσεις και ημέρες συγκρίνονται με &lt; και &gt;· γράψτε %1:value.</translation>
    </message>
    <message>
      <source>The filter has no field &apos;%1&apos;; write extra.%1 for a custom field, or enclose the word in quotation marks to search for it literally.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το φίλτρο δεν γνωρίζει πεδίο &apos;%1&apos;· γράψτε extra.%1 για δικό σας πεδίο ή βάλτε τη λέξη σε εισαγωγικά για να αναζητηθεί όπως είναι.</translation>
    </message>
    <message>
      <source>Write the date in EDTF, for example -0599/-0549~ (600 to about 550 BC), -1149? or 0350/..; years have four digits, and words such as MB II belong in the field for the period.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια χρονολόγηση γράφεται σε EDTF, όπως -0599/-0549~ (600 έως περίπου 550 π.Χ.), -1149? ή 0350/..· τα έτη έχουν τέσσερα ψηφία, και λέξεις όπως MB II ανήκουν στο πεδίο της περιόδου.</translation>
    </message>
    <message>
      <source>Enter the context with its site and trench, such as KT26-A-012.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Γράψτε το πλαίσιο με τη θέση και την τομή του, για παράδειγμα KT26-A-012.</translation>
    </message>
    <message>
      <source>Scale: none; lengths in mm are based on a guess.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: καμία· τα μήκη σε mm βασίζονται σε εκτίμηση.</translation>
    </message>
    <message>
      <source>Scale: the board of board.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: ο πίνακας του board.json.</translation>
    </message>
    <message>
      <source>Scale: the lengths marked in scale.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: τα μήκη που σημειώθηκαν στο scale.json.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as typed at the import.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: δείκτες %1 mm, όπως πληκτρολογήθηκε κατά την εισαγωγή.</translation>
    </message>
    <message>
      <source>Scale: markers of %1 mm, as in plate.json.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: δείκτες %1 mm, όπως στο plate.json.</translation>
    </message>
    <message>
      <source>Scale: the markers that plate.json describes.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: οι δείκτες που περιγράφει το plate.json.</translation>
    </message>
    <message>
      <source>Scale: that of the imported scans.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλίμακα: αυτή των εισαγμένων σαρώσεων.</translation>
    </message>
    <message>
      <source>The scale of this batch is its rig&apos;s; calibrate the rig to correct it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η κλίμακα αυτής της παρτίδας είναι της διάταξής της· βαθμονομήστε τη διάταξη για να διορθωθεί.</translation>
    </message>
    <message>
      <source>The markers of this sheet are of several sizes; correct its plate.json by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι δείκτες αυτού του φύλλου έχουν διάφορα μεγέθη· διορθώστε το plate.json του με το χέρι.</translation>
    </message>
    <message>
      <source>These results contain a measurement larger than any sherd; run &apos;ostraka process&apos; again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτά τα αποτελέσματα περιέχουν μια μέτρηση μεγαλύτερη από κάθε όστρακο· εκτελέστε ξανά το &apos;ostraka process&apos;.</translation>
    </message>
    <message>
      <source>This project lies in the archive &apos;%1&apos;, which any change would make invalid; restore the archive to a new folder, and open that.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο βρίσκεται στο αρχείο έργου «%1», που θα έπαυε να ισχύει με κάθε αλλαγή· επαναφέρετε το αρχείο έργου σε νέο φάκελο και ανοίξτε εκείνον.</translation>
    </message>
    <message>
      <source>Not a location of photographs, results, models or imported files, the only files that a merge writes; nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι θέση φωτογραφιών, αποτελεσμάτων, μοντέλων ή εισαγμένων αρχείων, των μόνων αρχείων που γράφει μια συγχώνευση· τίποτα δεν συγχωνεύτηκε.</translation>
    </message>
    <message>
      <source>A point, a normal or a quality of the scan is not finite; leave such points out.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα σημείο, μια κάθετος ή μια ποιότητα της σάρωσης δεν είναι πεπερασμένη· παραλείψτε τέτοια σημεία.</translation>
    </message>
    <message>
      <source>The lists of this cloud or mesh differ in length, or a triangle names a vertex that does not exist; nothing was written.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι λίστες αυτού του νέφους σημείων ή πλέγματος έχουν διαφορετικό μήκος, ή ένα τρίγωνο αναφέρει κορυφή που δεν υπάρχει· δεν γράφτηκε τίποτα.</translation>
    </message>
    <message>
      <source>The transform puts the back %1 mm away from the front; give one that takes points of the back to the front&apos;s frame.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο μετασχηματισμός τοποθετεί την πίσω όψη %1 mm μακριά από την μπροστινή όψη· δώστε έναν που μεταφέρει τα σημεία της πίσω όψης στο σύστημα της μπροστινής.</translation>
    </message>
    <message>
      <source>The model has no photographs, so the orthophoto shows the colours of its vertices.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μοντέλο δεν έχει φωτογραφίες, γι&apos; αυτό η ορθοφωτογραφία δείχνει τα χρώματα των κορυφών του.</translation>
    </message>
    <message>
      <source>The model has neither photographs nor colours, so there is no orthophoto of it; draw its shaded form.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μοντέλο δεν έχει ούτε φωτογραφίες ούτε χρώματα, άρα δεν υπάρχει ορθοφωτογραφία του· σχεδιάστε τη σκιασμένη μορφή του.</translation>
    </message>
    <message>
      <source>%1: 1 point whose normal has no direction was left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: 1 σημείο του οποίου η κάθετος δεν έχει διεύθυνση παραλείφθηκε· ελέγξτε την εξαγωγή.</translation>
    </message>
    <message>
      <source>%1: %2 points whose normals have no direction were left out; check the export.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: %2 σημεία των οποίων οι κάθετοι δεν έχουν διεύθυνση παραλείφθηκαν· ελέγξτε την εξαγωγή.</translation>
    </message>
    <message>
      <source>The photograph is less than %1 pixels wide or high; use the original photograph.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η φωτογραφία έχει πλάτος ή ύψος μικρότερο από %1 εικονοστοιχεία· χρησιμοποιήστε την αρχική φωτογραφία.</translation>
    </message>
    <message>
        <source>The project has no site yet; add a column &apos;Site&apos;, or write the context with its site, such as %1.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Το έργο δεν έχει ακόμη θέση· προσθέστε μια στήλη «Θέση» ή γράψτε το πλαίσιο με τη θέση του, όπως %1.</translation>
    </message>
    <message>
        <source>This project has %1 sites; add a column &apos;Site&apos;, or write the context with its site, such as %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Αυτό το έργο έχει %1 θέσεις· προσθέστε μια στήλη «Θέση» ή γράψτε το πλαίσιο με τη θέση του, όπως %2.</translation>
    </message>
    <message>
        <source>The site %1 has %2 trenches; add a column &apos;Trench&apos;, or write the context with its trench, such as %3.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Η θέση %1 έχει %2 τομές· προσθέστε μια στήλη «Τομή» ή γράψτε το πλαίσιο με την τομή του, όπως %3.</translation>
    </message>
    <message>
        <source>There is no such trench in the site %1; write trench and context in columns of their own.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Δεν υπάρχει τέτοια τομή στη θέση %1· γράψτε την τομή και το πλαίσιο σε δικές τους στήλες.</translation>
    </message>
    <message>
        <source>The backups %1 and %2 are of different projects, and nothing tells which of them this folder is; nothing was changed. Move those of the other project away, then repair it again.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Τα αντίγραφα ασφαλείας %1 και %2 είναι διαφορετικών έργων και τίποτα δεν δείχνει ποιο από αυτά είναι αυτός ο φάκελος· δεν άλλαξε τίποτα. Μετακινήστε αλλού εκείνα του άλλου έργου και επιδιορθώστε ξανά.</translation>
    </message>
    <message>
        <source>This can be %1 or %2; enter site, trench and context each by itself.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μπορεί να είναι %1 ή %2· εισαγάγετε χωριστά τη θέση, την τομή και το πλαίσιο.</translation>
    </message>
    <message>
        <source>The table needs a column for the sherds&apos; numbers, or one for the contexts (a table of contexts); select it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο πίνακας χρειάζεται μια στήλη για τους αριθμούς των οστράκων ή μια για τα πλαίσια (πίνακας πλαισίων)· επιλέξτε την.</translation>
    </message>
    <message>
      <source>The number needs the trench of the sherd, which is not recorded; choose a context in a trench, or change the numbering in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός χρειάζεται την τομή του οστράκου, που δεν έχει καταχωριστεί· επιλέξτε πλαίσιο μέσα σε τομή ή αλλάξτε την αρίθμηση στις ρυθμίσεις.</translation>
    </message>
    <message>
      <source>This folder on the cluster belongs to another project, to another copy of this one, or to this one before it was moved; nothing was sent. Name another folder with --host. If nothing else uses this one, delete &apos;cluster/owner&apos; in it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος της συστοιχίας ανήκει σε άλλο έργο, σε άλλο αντίγραφο αυτού του έργου ή σε αυτό το έργο πριν μετακινηθεί· δεν στάλθηκε τίποτα. Δώστε άλλον φάκελο με --host. Αν δεν τον χρησιμοποιεί τίποτε άλλο, διαγράψτε μέσα του το &apos;cluster/owner&apos;.</translation>
    </message>
    <message>
      <source>This changed while a merge was being completed, so it was kept, but the catalogue has what was merged. Reprocess the batch.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό άλλαξε ενώ ολοκληρωνόταν μια συγχώνευση, γι’ αυτό διατηρήθηκε, αλλά ο κατάλογος έχει ό,τι συγχωνεύτηκε. Επανεπεξεργαστείτε την παρτίδα.</translation>
    </message>
    <message>
      <source>line</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>γραμμή</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πεδίο</translation>
    </message>
    <message>
      <source>value</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τιμή</translation>
    </message>
    <message>
      <source>A sparse object of %1 points at x %2, y %3 mm was left out; if it is a sherd, photograph it closer.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα αντικείμενο με μόνο %1 σημεία στο x %2, y %3 mm έμεινε στην άκρη· αν είναι όστρακο, φωτογραφίστε το από πιο κοντά.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs or scans of %3 belong to %4, too: its sherds would be in the catalogue twice. Nothing was entered. Set %3 aside and use %4, or keep both: 'Keep both' in the queue, 'ostraka catalogue enter --keep-both' on the command line.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 από τις %2 φωτογραφίες ή σαρώσεις του %3 ανήκουν και στο %4: τα όστρακά του θα βρίσκονταν δύο φορές στον κατάλογο. Δεν καταχωρίστηκε τίποτα. Βάλτε το %3 στην άκρη και χρησιμοποιήστε το %4, ή κρατήστε και τα δύο: «Διατήρηση και των δύο» στην ουρά, 'ostraka catalogue enter --keep-both' στη γραμμή εντολών.</translation>
    </message>
    <message>
      <source>%1 of the %2 photographs of %3, which this export holds, belong to %4, too: its sherds would be in the catalogue twice. Use %4 and leave the export out, or keep both on purpose (on the command line: --keep-both).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 από τις %2 φωτογραφίες του %3, που περιέχει αυτή η εξαγωγή, ανήκουν και στο %4: τα όστρακά του θα βρίσκονταν δύο φορές στον κατάλογο. Χρησιμοποιήστε το %4 χωρίς την εξαγωγή, ή κρατήστε σκόπιμα και τα δύο (στη γραμμή εντολών: --keep-both).</translation>
    </message>
    <message>
      <source>Another run is writing to this folder. What it has saved is kept, and this run has changed nothing; wait until the other one ends, or choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια άλλη εκτέλεση γράφει σε αυτόν τον φάκελο. Ό,τι έχει αποθηκεύσει διατηρείται, και αυτή εδώ δεν άλλαξε τίποτα· περιμένετε να τελειώσει η άλλη ή επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>The photographs do not tell the light from the sherds' own colours, so textures stay as photographed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες δεν επιτρέπουν να διακριθεί το φως από τα χρώματα των ίδιων των οστράκων· οι υφές μένουν όπως φωτογραφήθηκαν.</translation>
    </message>
    <message>
      <source>Ostraka needs this folder for its own files, but it contains others. They are unchanged; move them elsewhere, then start again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το Ostraka χρειάζεται αυτόν τον φάκελο για τα δικά του αρχεία, αλλά περιέχει άλλα. Είναι αμετάβλητα· μετακινήστε τα αλλού και ξεκινήστε ξανά.</translation>
    </message>
    <message>
      <source>This is not the location of a photograph, result, model or imported file, the only files that a catalogue lists. Nothing was changed; use a backup or another copy of the project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν είναι θέση φωτογραφίας, αποτελέσματος, μοντέλου ή εισαγμένου αρχείου, των μόνων αρχείων που απαριθμεί ένας κατάλογος. Δεν άλλαξε τίποτα· χρησιμοποιήστε αντίγραφο ασφαλείας ή άλλο αντίγραφο του έργου.</translation>
    </message>
    <message>
      <source>The catalogue has earlier results of %1, and the batch is queued again. Enter the new ones with &apos;ostraka catalogue enter&apos;, or reprocess it in the window.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο κατάλογος έχει παλαιότερα αποτελέσματα της %1 και η παρτίδα μπήκε ξανά στην ουρά. Καταχωρίστε τα νέα με &apos;ostraka catalogue enter&apos; ή επεξεργαστείτε την ξανά στο παράθυρο.</translation>
    </message>
    <message>
      <source>The folder on the cluster has files that Ostraka did not write (%1): %2. They were left there.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος στη συστοιχία έχει αρχεία που δεν έγραψε το Ostraka (%1): %2. Έμειναν εκεί.</translation>
    </message>
    <message>
      <source>The output folder contains the results of other scans, or of these before a file was changed, renamed, added or removed; choose another folder.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο φάκελος εξόδου περιέχει τα αποτελέσματα άλλων σαρώσεων, ή αυτών πριν αλλάξει, μετονομαστεί, προστεθεί ή αφαιρεθεί κάποιο αρχείο· επιλέξτε άλλον φάκελο.</translation>
    </message>
    <message>
      <source>The interval ends before it begins: %1 is earlier than %2; write the earlier date first, and years BC with a minus sign.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το διάστημα τελειώνει πριν αρχίσει: το %1 προηγείται του %2· γράψτε πρώτα την παλαιότερη χρονολογία, και τα έτη π.Χ. με το σημείο μείον.</translation>
    </message>
    <message>
      <source>The number %1 differs from the existing number %2 only in zeros, letter case or punctuation; check which one is meant.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 διαφέρει από τον υπάρχοντα αριθμό %2 μόνο στα μηδενικά, στα πεζά ή κεφαλαία ή στα σημεία στίξης· ελέγξτε ποιος εννοείται.</translation>
    </message>
    <message>
      <source>New numbers differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέοι αριθμοί διαφέρουν από υπάρχοντες μόνο στα μηδενικά, στα πεζά ή κεφαλαία ή στα σημεία στίξης: %1· ελέγξτε για τυπογραφικά λάθη.</translation>
    </message>
    <message>
      <source>New contexts differ from existing ones only in zeros, letter case or punctuation: %1; check for typos.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέα πλαίσια διαφέρουν από υπάρχοντα μόνο στα μηδενικά, στα πεζά ή κεφαλαία ή στα σημεία στίξης: %1· ελέγξτε για τυπογραφικά λάθη.</translation>
    </message>
    <message>
      <source>A spreadsheet may have shortened these numbers or turned them into dates: %1; compare them with the labels and correct them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα λογιστικό φύλλο ίσως συντόμευσε αυτούς τους αριθμούς ή τους μετέτρεψε σε ημερομηνίες: %1· συγκρίνετέ τους με τις ετικέτες και διορθώστε τους.</translation>
    </message>
    <message>
      <source>This file differs from what &apos;ostraka process&apos; wrote; run it again, which writes the file anew.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το αρχείο διαφέρει από αυτό που έγραψε το 'ostraka process'· εκτελέστε το ξανά και θα γραφτεί εκ νέου.</translation>
    </message>
    <message>
      <source>The name of the file %1 is not UTF-8, and results could not tell it from others; rename it, then try again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα του αρχείου %1 δεν είναι σε UTF-8 και τα αποτελέσματα δεν θα μπορούσαν να το ξεχωρίσουν από άλλα· μετονομάστε το και δοκιμάστε ξανά.</translation>
    </message>
    <message>
      <source>Usable photographs of the front side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμες φωτογραφίες της μπροστινής όψης: %1· χρειάζονται τουλάχιστον %2. Φωτογραφίες που παραλείφθηκαν: %3· η πρώτη: %4</translation>
    </message>
    <message>
      <source>Usable photographs of the back side: %1; at least %2 are needed. Photographs left out: %3; the first: %4</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Χρησιμοποιήσιμες φωτογραφίες της πίσω όψης: %1· χρειάζονται τουλάχιστον %2. Φωτογραφίες που παραλείφθηκαν: %3· η πρώτη: %4</translation>
    </message>
    <message>
      <source>The number %1 was assigned before and is never reused; nothing was merged. Settle the conflict %2 with another number.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ο αριθμός %1 έχει ήδη δοθεί και δεν ξαναχρησιμοποιείται ποτέ· δεν συγχωνεύτηκε τίποτα. Λύστε τη σύγκρουση %2 με άλλον αριθμό.</translation>
    </message>
    <message>
      <source>An entry of this file does not have the form {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (or &quot;b&quot; or &quot;one&quot;, or &quot;number&quot; with a new number): %1; nothing was merged. Correct the entry.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια εγγραφή του αρχείου δεν έχει τη μορφή {&quot;id&quot;: &quot;…&quot;, &quot;take&quot;: &quot;a&quot;} (ή &quot;b&quot; ή &quot;one&quot;, ή &quot;number&quot; με νέο αριθμό): %1· δεν συγχωνεύτηκε τίποτα. Διορθώστε την εγγραφή.</translation>
    </message>
    <message>
      <source>The name of a place must not be empty; nothing was renamed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το όνομα ενός τόπου δεν μπορεί να είναι κενό· τίποτα δεν μετονομάστηκε.</translation>
    </message>
    <message>
      <source>Another place has the name %1 by now; nothing was undone.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλος τόπος έχει πλέον το όνομα %1· τίποτα δεν αναιρέθηκε.</translation>
    </message>
    <message>
      <source>This disk does not accept this name; rename the file, or use a folder on another disk.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο δίσκος δεν δέχεται αυτό το όνομα· μετονομάστε το αρχείο ή χρησιμοποιήστε έναν φάκελο σε άλλον δίσκο.</translation>
    </message>
    <message>
      <source>A file of an earlier merge cannot be moved to its place, %1. Make it possible (move away what lies there, or copy the project to another disk), or delete the file; then merge again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα αρχείο προηγούμενης συγχώνευσης δεν μπορεί να μετακινηθεί στη θέση του, %1. Κάντε το δυνατό (μετακινήστε ό,τι βρίσκεται εκεί ή αντιγράψτε το έργο σε άλλον δίσκο) ή διαγράψτε το αρχείο· έπειτα συγχωνεύστε ξανά.</translation>
    </message>
    <message>
      <source>It belongs to a merge and waits in %1; moving it to its place is tried again whenever the project is opened.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το αρχείο ανήκει σε μια συγχώνευση και περιμένει στο %1· η μετακίνησή του στη θέση του δοκιμάζεται ξανά κάθε φορά που ανοίγει το έργο.</translation>
    </message>
    <message>
      <source>The block of numbers of this computer begins or ends with &apos;%1&apos;, but must be of whole numbers from 1 to %2; set it in the settings.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σειρά αριθμών αυτού του υπολογιστή αρχίζει ή τελειώνει με «%1», αλλά πρέπει να αποτελείται από ακέραιους αριθμούς από 1 ως %2· ορίστε την στις ρυθμίσεις.</translation>
    </message>
    <message>
      <source>Photographs of %1 that these results were not made from: %2, the first is %3. Reprocess the batch to use them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φωτογραφίες της %1 από τις οποίες δεν έγιναν αυτά τα αποτελέσματα: %2, η πρώτη είναι η %3. Επεξεργαστείτε ξανά την παρτίδα για να χρησιμοποιηθούν.</translation>
    </message>
    <message>
      <source>These results do not say which photographs they were made from, so they are not entered; process %1 again.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτά τα αποτελέσματα δεν λένε από ποιες φωτογραφίες έγιναν, γι’ αυτό δεν καταχωρίζονται· επεξεργαστείτε ξανά την %1.</translation>
    </message>
    <message>
      <source>The GLB beside this model has another shape, so it is that of another sherd or of an earlier run; put its own beside it.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το GLB δίπλα σε αυτό το μοντέλο έχει άλλο σχήμα, άρα ανήκει σε άλλο όστρακο ή σε προηγούμενη επεξεργασία· βάλτε δίπλα το δικό του.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ToolRow</name>
    <message>
        <source>More</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Περισσότερα</translation>
    </message>
    <message>
        <source>More tools</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Περισσότερα εργαλεία</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1, πλήκτρο %2</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ColumnTable</name>
    <message>
        <source>says nothing about the sherd</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>δεν λέει τίποτα για το όστρακο</translation>
    </message>
    <message>
        <source>only shown, never read</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>μόνο εμφανίζεται, δεν διαβάζεται ποτέ</translation>
    </message>
    <message>
        <source>share of 1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>μερίδιο του 1</translation>
    </message>
    <message>
        <source>unit guessed from the values; check it</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>η μονάδα συνάγεται από τις τιμές· ελέγξτε την</translation>
    </message>
    <message>
        <source>as in the last table with these columns</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>όπως στον τελευταίο πίνακα με αυτές τις στήλες</translation>
    </message>
    <message>
        <source>chosen by you</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>επιλεγμένο από εσάς</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Στήλες του πίνακα</translation>
    </message>
    <message>
        <source>column</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>στήλη</translation>
    </message>
    <message>
        <source>field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>πεδίο</translation>
    </message>
    <message>
        <source>unit</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>μονάδα</translation>
    </message>
    <message>
        <source>first values</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>πρώτες τιμές</translation>
    </message>
    <message>
        <source>why</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>γιατί</translation>
    </message>
    <message>
        <source>Field of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Πεδίο της στήλης %1</translation>
    </message>
    <message>
        <source>Unit of the column %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μονάδα της στήλης %1</translation>
    </message>
    <message>
        <source>skip</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>παράλειψη</translation>
    </message>
    <message>
        <source>custom field: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>δικό σας πεδίο: %1</translation>
    </message>
    <message>
        <source>no field of this name; kept as a custom field</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>κανένα πεδίο με αυτό το όνομα· διατηρείται ως δικό σας πεδίο</translation>
    </message>
    <message>
      <source>proposed by its heading</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προτείνεται από την επικεφαλίδα</translation>
    </message>
</context>
<context>
    <name>ImportSides</name>
    <message>
      <source>Drop either folders or photographs, not both.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αφήστε είτε φακέλους είτε φωτογραφίες, όχι και τα δύο.</translation>
    </message>
    <message>
      <source>These are more than two folders; drop that of the fronts and that of the backs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Είναι περισσότεροι από δύο φάκελοι· αφήστε αυτόν των μπροστινών και αυτόν των πίσω όψεων.</translation>
    </message>
    <message>
      <source>There are no photographs in this folder; choose one that holds them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε αυτόν τον φάκελο δεν υπάρχουν φωτογραφίες· επιλέξτε έναν που τις περιέχει.</translation>
    </message>
    <message>
      <source>This folder contains several folders with photographs (%1); drop the two of one batch, front and back, onto this page.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτός ο φάκελος περιέχει πολλούς φακέλους με φωτογραφίες (%1)· αφήστε σε αυτή τη σελίδα τους δύο μιας παρτίδας, μπροστινή και πίσω όψη.</translation>
    </message>
    <message>
      <source>The photographs of this folder are those of the front already; choose another folder for the back, or divide the series with the slider.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Οι φωτογραφίες αυτού του φακέλου είναι ήδη της μπροστινής όψης· επιλέξτε άλλον φάκελο για την πίσω όψη ή διαιρέστε τη σειρά με τον ρυθμιστή.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ImportChooser</name>
    <message>
      <source>Folder with front/ and back/ scans</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος με σαρώσεις front/ και back/</translation>
    </message>
    <message>
      <source>Folder of a batch, or with photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος παρτίδας ή με φωτογραφίες</translation>
    </message>
    <message>
      <source>Folder of the back photographs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος φωτογραφιών της πίσω όψης</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SidesView</name>
    <message>
      <source>One side only</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μόνο μία όψη</translation>
    </message>
    <message>
      <source>Swap sides</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εναλλαγή όψεων</translation>
    </message>
    <message>
      <source>First photograph of the second side</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρώτη φωτογραφία της δεύτερης όψης</translation>
    </message>
    <message>
      <source>Choose sheet…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή φύλλου…</translation>
    </message>
    <message>
      <source>Clear sheet</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αφαίρεση φύλλου</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s &amp;black square</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλευρά του &amp;μαύρου τετραγώνου δείκτη</translation>
    </message>
    <message>
      <source>Unknown</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άγνωστο</translation>
    </message>
    <message>
      <source> mm</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation> mm</translation>
    </message>
    <message>
      <source>The sheet will be found in the photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το φύλλο θα βρεθεί στις φωτογραφίες.</translation>
    </message>
    <message>
      <source>No sheet file (plate.json) and no marker size: the result has no scale.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ούτε αρχείο φύλλου (plate.json) ούτε μέγεθος δείκτη: το αποτέλεσμα δεν έχει κλίμακα.</translation>
    </message>
    <message>
      <source>Sheet under the sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φύλλο κάτω από τα όστρακα</translation>
    </message>
    <message>
      <source>Sheet (*.json)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φύλλο (*.json)</translation>
    </message>
    <message>
      <source>Front</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μπροστινή όψη</translation>
    </message>
    <message>
      <source>Back</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πίσω όψη</translation>
    </message>
    <message>
      <source>The series is divided where the sherds were turned over.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η σειρά χωρίζεται εκεί όπου γύρισαν τα όστρακα.</translation>
    </message>
    <message>
      <source>Sheet: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φύλλο: %1</translation>
    </message>
    <message>
      <source>%1: none</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1: καμία</translation>
    </message>
    <message numerus="yes">
      <source>%1: %n photograph(s), %2 to %3</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%1: %n φωτογραφία, %2 έως %3</numerusform>
        <numerusform>%1: %n φωτογραφίες, %2 έως %3</numerusform>
      </translation>
    </message>
    <message>
      <source>The marker size is proposed from the last import: check it with a ruler.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το μέγεθος των δεικτών προτείνεται από την τελευταία εισαγωγή: ελέγξτε το με χάρακα.</translation>
    </message>
    <message>
      <source>Choose back folder…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή φακέλου πίσω όψεων…</translation>
    </message>
    <message>
      <source>A folder that holds both sides is split where the sherds were turned over; the folder of the back photographs replaces the split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένας φάκελος με τις δύο όψεις χωρίζεται εκεί όπου γύρισαν τα όστρακα· ο φάκελος των πίσω όψεων αντικαθιστά τον χωρισμό</translation>
    </message>
    <message>
      <source>No pause stands out between the photographs. Where the two pictures beside the division show the sherds before and after they were turned over, divide here; else move the slider, or choose the folder of the back photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν ξεχωρίζει παύση ανάμεσα στις φωτογραφίες. Αν οι δύο εικόνες δίπλα στη διαίρεση δείχνουν τα όστρακα πριν και αφού γυρίστηκαν, διαιρέστε εδώ· αλλιώς μετακινήστε τον ρυθμιστή ή επιλέξτε τον φάκελο με τις φωτογραφίες της πίσω όψης.</translation>
    </message>
    <message>
      <source>Divide here</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διαίρεση εδώ</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CatalogueRepair</name>
    <message>
        <source>It is whole; nothing was changed.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Είναι ακέραιος· τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>Nothing in the damaged file could be read: it is that of %1 again. Look what is missing since.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Τίποτα δεν μπορούσε να διαβαστεί στο κατεστραμμένο αρχείο: ισχύει πάλι αυτό του %1. Δείτε τι λείπει από τότε.</translation>
    </message>
    <message>
        <source>An earlier repair was interrupted and is now finished. Check the catalogue for missing changes.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Μια προηγούμενη επισκευή διακόπηκε και τώρα ολοκληρώθηκε. Ελέγξτε αν λείπουν αλλαγές από τον κατάλογο.</translation>
    </message>
    <message>
        <source>Everything in it is as it was.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Όλα μέσα του είναι όπως ήταν.</translation>
    </message>
    <message>
        <source>All %1 rows stand in %2.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Και οι %1 γραμμές βρίσκονται στο %2.</translation>
    </message>
    <message>
        <source>The damaged file is kept: %1</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Το κατεστραμμένο αρχείο φυλάσσεται: %1</translation>
    </message>
    <message>
        <source>Another window has this project open: close it there, then repair it.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Άλλο παράθυρο έχει ανοιχτό αυτό το έργο: κλείστε το εκεί και μετά επισκευάστε το.</translation>
    </message>
    <message>
        <source>The catalogue is being repaired …</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο κατάλογος επισκευάζεται …</translation>
    </message>
    <message>
        <source>The catalogue could not be repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο κατάλογος δεν μπόρεσε να επισκευαστεί.</translation>
    </message>
    <message>
        <source>The catalogue is repaired.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Ο κατάλογος επισκευάστηκε.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeDialog</name>
    <message>
      <source>Merge another project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συγχώνευση άλλου έργου</translation>
    </message>
    <message>
      <source>Conflicts</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διαφωνίες</translation>
    </message>
    <message>
      <source>Record</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εγγραφή</translation>
    </message>
    <message>
      <source>Field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πεδίο</translation>
    </message>
    <message>
      <source>This project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο</translation>
    </message>
    <message>
      <source>Other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλο έργο</translation>
    </message>
    <message>
      <source>Decision</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Απόφαση</translation>
    </message>
    <message>
      <source>New number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος αριθμός</translation>
    </message>
    <message>
      <source>Undo</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αναίρεση</translation>
    </message>
    <message>
      <source>All open ones: this project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όλες οι ανοιχτές: αυτό το έργο</translation>
    </message>
    <message>
      <source>Choose project…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλογή έργου …</translation>
    </message>
    <message>
      <source>Progress of the merge</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόοδος της συγχώνευσης</translation>
    </message>
    <message>
      <source>Folder of the other project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Φάκελος του άλλου έργου</translation>
    </message>
    <message>
      <source>New number %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος αριθμός %1</translation>
    </message>
    <message>
      <source>Open</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανοιχτή</translation>
    </message>
    <message>
      <source>What the other project holds comes into this one; the other one is only read. Nothing changes before you merge.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ό,τι περιέχει το άλλο έργο έρχεται σε αυτό· το άλλο μόνο διαβάζεται. Τίποτα δεν αλλάζει πριν από τη συγχώνευση.</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλείσιμο</translation>
    </message>
    <message>
      <source>Stop</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Διακοπή</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακύρωση</translation>
    </message>
    <message numerus="yes">
      <source>%n conflict(s) to settle</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n διαφωνία προς επίλυση</numerusform>
        <numerusform>%n διαφωνίες προς επίλυση</numerusform>
      </translation>
    </message>
    <message>
      <source>Merge project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συγχώνευση έργου</translation>
    </message>
    <message>
      <source>New number:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος αριθμός:</translation>
    </message>
    <message>
      <source>New number of the record that does not keep it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Νέος αριθμός της εγγραφής που δεν τον κρατά</translation>
    </message>
    <message>
      <source>Sherds with a new number</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα με νέο αριθμό</translation>
    </message>
    <message>
      <source>Copy list</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αντιγραφή λίστας</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο όστρακα: αυτού του έργου κρατά τον αριθμό, το άλλο παίρνει %1</translation>
    </message>
    <message>
      <source>Two sherds: this project&apos;s keeps the number, the other&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο όστρακα: αυτού του έργου κρατά τον αριθμό, το άλλο παίρνει νέον</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο όστρακα: το άλλο κρατά τον αριθμό, αυτού του έργου παίρνει %1</translation>
    </message>
    <message>
      <source>Two sherds: the other&apos;s keeps the number, this project&apos;s gets a new one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δύο όστρακα: το άλλο κρατά τον αριθμό, αυτού του έργου παίρνει νέον</translation>
    </message>
    <message>
      <source>One sherd: both records become one</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο: οι δύο εγγραφές γίνονται μία</translation>
    </message>
    <message>
      <source>Open; new number: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανοιχτή· νέος αριθμός: %1</translation>
    </message>
    <message>
      <source>One sherd</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ένα όστρακο</translation>
    </message>
    <message>
      <source>This project; the other sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο· το άλλο όστρακο: %1</translation>
    </message>
    <message>
      <source>Other project; this sherd: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άλλο έργο· αυτό το όστρακο: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MergeModel</name>
    <message>
      <source>Sherds: %1. Batches: %2. Changed records: %3. Files: %4 (%5).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα: %1. Παρτίδες: %2. Αλλαγμένες εγγραφές: %3. Αρχεία: %4 (%5).</translation>
    </message>
    <message>
      <source>Comparing…</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση …</translation>
    </message>
    <message>
      <source>Merged %1. %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συγχωνεύθηκε το %1. %2</translation>
    </message>
    <message>
      <source>This project already has everything that the other one holds.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Αυτό το έργο έχει ήδη όλα όσα περιέχει το άλλο.</translation>
    </message>
    <message>
      <source>Batches that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδες που παίρνουν εδώ άλλον αριθμό: %1</translation>
    </message>
    <message>
      <source>Sherds that get another number here: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα που παίρνουν εδώ άλλον αριθμό: %1</translation>
    </message>
    <message numerus="yes">
      <source>Missing in the other project: %n file(s), %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>Λείπει %n αρχείο από το άλλο έργο: %1</numerusform>
        <numerusform>Λείπουν %n αρχεία από το άλλο έργο: %1</numerusform>
      </translation>
    </message>
    <message>
      <source>Cancelled. Nothing was merged.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ακυρώθηκε. Δεν συγχωνεύθηκε τίποτα.</translation>
    </message>
    <message>
      <source>Nothing was merged yet: what you chose leads to further conflicts.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν συγχωνεύθηκε ακόμη τίποτα: οι επιλογές σας οδηγούν σε άλλες διαφωνίες.</translation>
    </message>
    <message>
      <source>An earlier merge was interrupted and could not be completed here: %1. What lies there is kept; the other project&apos;s version was left out, or waits in the folder merge.partial.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια προηγούμενη συγχώνευση διακόπηκε και δεν μπόρεσε να ολοκληρωθεί εδώ: %1. Ό,τι βρίσκεται εκεί διατηρείται· η εκδοχή του άλλου έργου παραλείφθηκε ή περιμένει στον φάκελο merge.partial.</translation>
    </message>
</context>
<context>
    <name>Verdicts</name>
    <message>
      <source>accepted</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>αποδεκτό</translation>
    </message>
    <message>
      <source>rejected</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>απορρίφθηκε</translation>
    </message>
    <message>
      <source>set aside</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>στην άκρη</translation>
    </message>
    <message>
      <source>to be photographed again</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>προς νέα λήψη</translation>
    </message>
    <message>
      <source>merged</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>συγχωνεύθηκαν</translation>
    </message>
    <message>
      <source>split</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διαιρέθηκε</translation>
    </message>
    <message>
      <source>withdrawn</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ανακλήθηκε</translation>
    </message>
    <message>
      <source>pair of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>ζεύγος του %1</translation>
    </message>
    <message>
      <source>fragments: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>θραύσματα: %1</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlateScreen</name>
    <message>
      <source>Batch</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Παρτίδα</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::NoBatchYet</name>
    <message>
        <source>Capture a batch</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Λήψη παρτίδας</translation>
    </message>
    <message>
      <source>Show the queue</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Εμφάνιση της ουράς</translation>
    </message>
    <message>
      <source>%1 is in the queue; its results appear here when it is processed.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 είναι στην ουρά· τα αποτελέσματά του εμφανίζονται εδώ μόλις υποβληθεί σε επεξεργασία.</translation>
    </message>
    <message>
      <source>%1 could not be processed; the queue says why.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Η επεξεργασία του %1 δεν ήταν δυνατή· η ουρά λέει γιατί.</translation>
    </message>
</context>
<context>
    <name>Outside</name>
    <message>
      <source>No program was found that opens %1. It is there: open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν βρέθηκε πρόγραμμα που να ανοίγει το %1. Υπάρχει: ανοίξτε το με το χέρι.</translation>
    </message>
    <message>
      <source>Opening %1. If it does not appear, open it by hand.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Άνοιγμα του %1. Αν δεν εμφανιστεί, ανοίξτε το με το χέρι.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MarkerSide</name>
    <message>
      <source>Marker side of %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλευρά δείκτη της %1</translation>
    </message>
    <message>
      <source>Side of a marker&apos;s black square, mm. The batch is reprocessed with this size.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πλευρά του μαύρου τετραγώνου ενός δείκτη, mm. Η παρτίδα υποβάλλεται ξανά σε επεξεργασία με αυτό το μέγεθος.</translation>
    </message>
    <message>
      <source>marker side typed anew</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>η πλευρά του δείκτη δόθηκε ξανά</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PrintSheetButton</name>
    <message>
        <source>Print a sheet…</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εκτύπωση φύλλου…</translation>
    </message>
    <message>
        <source>Markers around the sherds give photographs taken by hand their scale</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Οι δείκτες γύρω από τα όστρακα δίνουν κλίμακα στις φωτογραφίες που λαμβάνονται με το χέρι</translation>
    </message>
    <message>
        <source>Print it at 100 %, not fitted to the page, and measure the bar of the second page: it must be %1 mm long. The next import proposes this sheet. If the bar is not %1 mm long, choose Clear sheet there and type the measured side of a black square.</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>Εκτυπώστε το στο 100 %, χωρίς προσαρμογή στη σελίδα, και μετρήστε τη ράβδο της δεύτερης σελίδας: πρέπει να έχει μήκος %1 mm. Η επόμενη εισαγωγή προτείνει αυτό το φύλλο. Αν η ράβδος δεν έχει μήκος %1 mm, επιλέξτε εκεί «Αφαίρεση φύλλου» και πληκτρολογήστε τη μετρημένη πλευρά ενός μαύρου τετραγώνου.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::SurfaceChoice</name>
    <message>
      <source>Shaded form</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σκιασμένη μορφή</translation>
    </message>
    <message>
      <source>With paint and slip</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Με γραπτή διακόσμηση και επίχρισμα</translation>
    </message>
    <message>
      <source>Orthophoto, %1 dpi</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ορθοφωτογραφία, %1 dpi</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectCare</name>
    <message numerus="yes">
      <source>%n file(s) of this project are missing or were changed, first %1. Put them back from a copy; &apos;ostraka catalogue check&apos; lists all of them.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n αρχείο αυτού του έργου λείπει ή άλλαξε: %1. Επαναφέρετέ το από αντίγραφο· το «ostraka catalogue check» το αναφέρει.</numerusform>
        <numerusform>%n αρχεία αυτού του έργου λείπουν ή άλλαξαν, πρώτο το %1. Επαναφέρετέ τα από αντίγραφο· το «ostraka catalogue check» τα αναφέρει όλα.</numerusform>
      </translation>
    </message>
</context>
<context>
    <name>ostraka::ui::MunsellLine</name>
    <message>
      <source>Rough: no usable colour chart in these photographs.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κατά προσέγγιση: κανένας χρησιμοποιήσιμος χρωματικός πίνακας σε αυτές τις φωτογραφίες.</translation>
    </message>
    <message>
      <source>Measured by the colour chart (Delta E 2000: median %1, 95 % %2).</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρήθηκε με τον χρωματικό πίνακα (Delta E 2000: διάμεσος %1, 95 % %2).</translation>
    </message>
    <message>
      <source>Take over</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υιοθέτηση</translation>
    </message>
    <message>
      <source>Proposed: %1 (Delta E 2000: %2), then %3 (%4). %5</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόταση: %1 (Delta E 2000: %2), μετά %3 (%4). %5</translation>
    </message>
    <message>
      <source>Take over %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Υιοθέτηση %1</translation>
    </message>
    <message>
      <source>Of the side that was photographed first.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Της όψης που φωτογραφήθηκε πρώτη.</translation>
    </message>
    <message>
      <source>Of the side that was photographed second.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Της όψης που φωτογραφήθηκε δεύτερη.</translation>
    </message>
    <message>
      <source>Measured.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετρημένο.</translation>
    </message>
    <message>
      <source>No colours proposed: the model has no texture from photographs, or an earlier version of the program made it. Reprocess its batch to get proposals.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Δεν προτείνονται χρώματα: το μοντέλο δεν έχει υφή από φωτογραφίες ή το έφτιαξε παλαιότερη έκδοση του προγράμματος. Επεξεργαστείτε ξανά την παρτίδα του για προτάσεις.</translation>
    </message>
    <message>
      <source>Rough estimate.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πρόχειρη εκτίμηση.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::CompareWindow</name>
    <message>
      <source>only one entered</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>καταχωρημένο μόνο στο ένα</translation>
    </message>
    <message>
      <source>differs</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διαφέρει</translation>
    </message>
    <message>
      <source>differs: %1</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διαφέρει: %1</translation>
    </message>
    <message>
      <source>%1, within the uncertainty</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1, εντός της αβεβαιότητας</translation>
    </message>
    <message>
      <source>%1 ?</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>%1 ?</translation>
    </message>
    <message>
      <source>Compare sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σύγκριση οστράκων</translation>
    </message>
    <message>
      <source>Turn &amp;together</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>&amp;Κοινή περιστροφή</translation>
    </message>
    <message>
      <source>Off: each sherd is turned alone, until both lie alike. The scale stays the same.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Ανενεργό: κάθε όστρακο περιστρέφεται μόνο του, ώσπου να έχουν και τα δύο τον ίδιο προσανατολισμό. Η κλίμακα μένει ίδια.</translation>
    </message>
    <message>
      <source>Section</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τομή</translation>
    </message>
    <message>
      <source>From above</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Από πάνω</translation>
    </message>
    <message>
      <source>Fields and measurements of both sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Πεδία και μέτρα και των δύο οστράκων</translation>
    </message>
    <message>
      <source>Model of %1; the arrow keys turn it</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μοντέλο του %1· τα βέλη το περιστρέφουν</translation>
    </message>
    <message>
      <source>field</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>πεδίο</translation>
    </message>
    <message>
      <source>difference</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>διαφορά</translation>
    </message>
    <message numerus="yes">
      <source>%n field(s) differ.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
            <numerusform>%n πεδίο διαφέρει.</numerusform>
            <numerusform>%n πεδία διαφέρουν.</numerusform>
        </translation>
    </message>
    <message>
      <source>The two are recorded as joining.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τα δύο έχουν καταγραφεί ως συνανήκοντα.</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::ProjectRestoring</name>
    <message>
        <source>%1 %</source>
        <translatorcomment>not reviewed by a speaker</translatorcomment>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>ostraka::ui::PlacesDialog</name>
    <message>
      <source>Rename places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετονομασία τόπων</translation>
    </message>
    <message>
      <source>Choose the place that was typed wrongly and enter its right name. If that place exists already, both become one.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Επιλέξτε τον τόπο που γράφτηκε λάθος και δώστε το σωστό όνομά του. Αν ο τόπος αυτός υπάρχει ήδη, οι δύο γίνονται ένας.</translation>
    </message>
    <message>
      <source>Places of the project</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τόποι του έργου</translation>
    </message>
    <message>
      <source>Place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Τόπος</translation>
    </message>
    <message>
      <source>Sherds</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Όστρακα</translation>
    </message>
    <message>
      <source>Right name of the place</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σωστό όνομα του τόπου</translation>
    </message>
    <message>
      <source>Rename</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετονομασία</translation>
    </message>
    <message>
      <source>Close</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Κλείσιμο</translation>
    </message>
    <message>
      <source>Right &amp;name:</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σωστό ό&amp;νομα:</translation>
    </message>
    <message numerus="yes">
      <source>%n context(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n πλαίσιο</numerusform>
        <numerusform>%n πλαίσια</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n bag(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n σακούλα</numerusform>
        <numerusform>%n σακούλες</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n batch(es)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n παρτίδα</numerusform>
        <numerusform>%n παρτίδες</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s)</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο</numerusform>
        <numerusform>%n όστρακα</numerusform>
      </translation>
    </message>
    <message>
      <source>nothing</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>τίποτα</translation>
    </message>
    <message>
      <source>%1 exists already. Join with it? What is in %2 comes to %1: %3. %1 keeps its own description, and %2 is not listed any more.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Το %1 υπάρχει ήδη. Συνένωση με αυτό; Ό,τι βρίσκεται στο %2 περνά στο %1: %3. Το %1 κρατά τη δική του περιγραφή και το %2 δεν εμφανίζεται πια.</translation>
    </message>
    <message>
      <source>In this place: %1.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Σε αυτόν τον τόπο: %1.</translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) keep the number that is written on them; new numbers go on behind these.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>
        <numerusform>%n όστρακο κρατά τον αριθμό που είναι γραμμένος πάνω του· οι νέοι αριθμοί συνεχίζουν μετά.</numerusform>
        <numerusform>%n όστρακα κρατούν τους αριθμούς που είναι γραμμένοι πάνω τους· οι νέοι αριθμοί συνεχίζουν μετά.</numerusform>
      </translation>
    </message>
    <message>
      <source>Join places</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συνένωση τόπων</translation>
    </message>
    <message>
      <source>join %1 with %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>συνένωση του %1 με το %2</translation>
    </message>
    <message>
      <source>rename %1 to %2</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>μετονομασία του %1 σε %2</translation>
    </message>
    <message>
      <source>Joined: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Συνενώθηκαν: το %1 είναι τώρα %2.</translation>
    </message>
    <message>
      <source>Renamed: %1 is %2 now.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μετονομάστηκε: το %1 είναι τώρα %2.</translation>
    </message>
    <message>
      <source>A site gets another code in the settings, under Open project.</source>
      <translatorcomment>not reviewed by a speaker</translatorcomment>
      <translation>Μια θέση παίρνει άλλον κωδικό στις ρυθμίσεις, στο «Ανοιχτό έργο».</translation>
    </message>
</context>
</TS>
